gg_layer(gather
         SOURCES classify.cpp closer_look.cpp direction_table.cpp error_budget.cpp free_space.cpp full_gather.cpp 
                 light_jumps.cpp light_tiles.cpp make_sites.cpp node_order.cpp perspective_grid.cpp pixel_map.cpp render_gather.cpp sender_cut.cpp
                 sender_group.cpp sender_light.cpp sender_measure.cpp sender_place.cpp sender_points.cpp shade.cpp shared_light.cpp shadow_samples.cpp shade_rays.cpp site_places.cpp site_receivers.cpp site_thresholds.cpp sky_leaves.cpp surroundings.cpp
         LINKS gg_film gg_perception gg_radiosity gg_transport gg_trace gg_scene gg_core)
