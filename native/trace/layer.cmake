gg_layer(trace SOURCES ray_tracer.cpp surface_point.cpp LINKS gg_scene embree)
