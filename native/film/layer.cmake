gg_layer(film SOURCES camera.cpp film.cpp fragments.cpp sample_color.cpp pixel_builder.cpp pixel_filter.cpp radiosity_view.cpp solution_view.cpp LINKS gg_trace gg_material gg_scene gg_core)
