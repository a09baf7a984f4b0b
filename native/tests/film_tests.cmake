gg_test(film_tests
        SOURCES film/camera_test.cpp film/film_test.cpp film/fragments_test.cpp film/pixel_filter_test.cpp film/sample_color_test.cpp
                film/solution_view_test.cpp
        LAYERS core image scene material trace film)
