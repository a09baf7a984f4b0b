gg_layer(gather
         SOURCES sender_points.cpp sender_light.cpp sender_cut.cpp near_light.cpp full_gather.cpp render_gather.cpp
         LINKS gg_film gg_radiosity gg_transport gg_trace gg_scene gg_core)
