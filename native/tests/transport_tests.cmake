gg_test(transport_tests
        SOURCES transport/bilinear_warp_test.cpp transport/fast_angle_test.cpp transport/directional_form_test.cpp
                transport/emitter_sampling_test.cpp transport/form_factor_accuracy_test.cpp transport/form_factor_area_test.cpp
                transport/form_factor_test.cpp transport/penumbra_test.cpp transport/sky_cell_test.cpp
                transport/spherical_rectangle_test.cpp
                oracles/form_factor_oracle.cpp
        LAYERS core image scene transport)
target_include_directories(transport_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
