gg_test(radiosity_tests
        SOURCES radiosity/brightness_test.cpp radiosity/cluster_tree_test.cpp radiosity/clustering_test.cpp radiosity/convergence_test.cpp radiosity/creases_test.cpp radiosity/dark_inside_test.cpp
                radiosity/energy_balance_test.cpp radiosity/exposure_test.cpp radiosity/face_groups_test.cpp radiosity/face_sampling_test.cpp
                radiosity/full_matrix_test.cpp
                radiosity/furnace_test.cpp radiosity/gathered_light_test.cpp radiosity/interpolation_test.cpp radiosity/large_faces_test.cpp radiosity/links_cover_once_test.cpp radiosity/mesh_balance_test.cpp
                radiosity/opinions_test.cpp radiosity/occluders_test.cpp radiosity/patches_test.cpp radiosity/path_irradiance_test.cpp radiosity/push_pull_test.cpp radiosity/reciprocity_test.cpp
                radiosity/seen_light_test.cpp radiosity/separators_test.cpp radiosity/settle_test.cpp radiosity/shadow_edges_test.cpp radiosity/sidedness_test.cpp radiosity/source_rays_test.cpp radiosity/surface_mesh_test.cpp radiosity/surface_strength_test.cpp radiosity/thin_elements_test.cpp radiosity/thread_count_test.cpp radiosity/visibility_test.cpp
                oracles/brute_visibility.cpp oracles/form_factor_oracle.cpp oracles/full_matrix_radiosity.cpp
                oracles/path_irradiance.cpp
                support/clouds.cpp support/face_points.cpp support/law_scenes.cpp support/meshes.cpp support/solution_measures.cpp support/surface_meshes.cpp
                support/test_scenes.cpp
        LAYERS core image scene material trace transport radiosity)
target_include_directories(radiosity_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
