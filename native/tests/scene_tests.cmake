gg_test(scene_tests
        SOURCES scene/build_scene_test.cpp scene/closed_solids_test.cpp scene/convert_mesh_test.cpp
                scene/enclosing_test.cpp scene/light_units_test.cpp scene/load_textures_test.cpp
                scene/place_instances_test.cpp scene/shading_vertices_test.cpp scene/weld_test.cpp support/meshes.cpp
        LAYERS core image scene)
target_include_directories(scene_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
