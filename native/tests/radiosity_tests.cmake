gg_test(radiosity_tests
        SOURCES support/test_scenes.cpp radiosity/energy_laws_test.cpp
        LAYERS core image scene material trace transport radiosity)
target_include_directories(radiosity_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
