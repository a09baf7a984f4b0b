gg_test(material_tests SOURCES material/surface_color_test.cpp LAYERS core image scene material)
