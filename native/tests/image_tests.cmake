gg_test(image_tests
        SOURCES image/display_transform_test.cpp image/view_curves_test.cpp image/mip_pyramid_test.cpp image/read_image_test.cpp image/texel_codec_test.cpp image/texture_test.cpp
                support/image_files.cpp
        LAYERS core image)
target_include_directories(image_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
