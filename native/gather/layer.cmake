gg_layer(gather
         SOURCES classify.cpp error_budget.cpp grid_sites.cpp perspective_grid.cpp sender_points.cpp sender_light.cpp sender_place.cpp sender_cut.cpp shade.cpp near_light.cpp full_gather.cpp render_gather.cpp
         LINKS gg_film gg_radiosity gg_transport gg_trace gg_scene gg_core)
