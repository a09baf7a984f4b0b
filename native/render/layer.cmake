gg_layer(render SOURCES capture.cpp pipeline.cpp prepared_scene.cpp
         LINKS gg_gather gg_film gg_radiosity gg_trace gg_material gg_scene gg_image gg_core)
