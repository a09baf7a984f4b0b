gg_test(trace_tests SOURCES trace/ray_tracer_test.cpp trace/surface_point_test.cpp LAYERS core image scene trace)
