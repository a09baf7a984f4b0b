gg_layer(material SOURCES surface_color.cpp LINKS gg_scene gg_image)
