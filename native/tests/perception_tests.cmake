gg_test(perception_tests
        SOURCES perception/csf_test.cpp perception/luminance_pyramid_test.cpp perception/masking_test.cpp
                perception/tvi_test.cpp
        LAYERS core perception)
target_include_directories(perception_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
