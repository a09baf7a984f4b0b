gg_layer(scene
         SOURCES build_scene.cpp closed_solids.cpp convert_mesh.cpp enclosing.cpp light_units.cpp load_textures.cpp
                 place_instances.cpp shading_vertices.cpp weld.cpp
         LINKS gg_image gg_core)
