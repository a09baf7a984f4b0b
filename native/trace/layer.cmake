gg_layer(trace SOURCES embree_scene.cpp ray_tracer.cpp surface_point.cpp LINKS gg_scene embree)
target_compile_definitions(gg_trace PRIVATE GG_EMBREE_MAJOR=${embree_VERSION_MAJOR})
