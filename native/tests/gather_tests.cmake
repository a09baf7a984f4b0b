gg_test(gather_tests
        SOURCES gather/classify_test.cpp gather/closer_look_test.cpp gather/continuity_test.cpp gather/direction_table_test.cpp
                gather/error_budget_test.cpp gather/free_space_test.cpp gather/gather_oracle_test.cpp gather/gather_test.cpp
                gather/light_jumps_test.cpp gather/perspective_grid_test.cpp gather/sender_cut_test.cpp
                gather/sender_group_test.cpp gather/sender_place_test.cpp gather/sender_points_test.cpp gather/shadow_samples_test.cpp
                gather/shared_light_test.cpp
                gather/site_irradiance_test.cpp gather/site_places_test.cpp gather/site_thresholds_test.cpp gather/surroundings_test.cpp
                oracles/path_irradiance.cpp oracles/site_irradiance.cpp oracles/solution_irradiance.cpp
                support/clouds.cpp support/face_points.cpp support/gather_scenes.cpp support/grid_picture.cpp
                support/law_scenes.cpp support/meshes.cpp support/test_scenes.cpp support/walks.cpp
        LAYERS core perception image scene material trace transport radiosity film gather)
target_include_directories(gather_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
