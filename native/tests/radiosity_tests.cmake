gg_test(radiosity_tests
        SOURCES radiosity/energy_balance_test.cpp radiosity/full_matrix_test.cpp radiosity/furnace_test.cpp
                oracles/form_factor_oracle.cpp oracles/full_matrix_radiosity.cpp
                support/clouds.cpp support/law_scenes.cpp support/solution_measures.cpp support/test_scenes.cpp
        LAYERS core image scene material trace transport radiosity)
target_include_directories(radiosity_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
