gg_layer(perception SOURCES csf.cpp luminance_pyramid.cpp masking.cpp tvi.cpp LINKS gg_core)
