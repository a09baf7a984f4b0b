gg_test(render_tests
        SOURCES render/capture_test.cpp support/clouds.cpp support/gather_scenes.cpp support/grid_picture.cpp support/law_scenes.cpp
                support/meshes.cpp support/test_scenes.cpp
        LAYERS core perception image scene material trace transport radiosity film gather render)
target_include_directories(render_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})

# Not a test by itself: tests of whole scenes run it on captures of them.
add_executable(capture_oracle capture_oracle.cpp oracles/solution_irradiance.cpp support/grid_picture.cpp
               support/test_scenes.cpp)
target_link_libraries(capture_oracle PRIVATE gg_core gg_perception gg_image gg_scene gg_material gg_trace gg_transport
                      gg_radiosity gg_film gg_gather gg_render)
target_include_directories(capture_oracle PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
