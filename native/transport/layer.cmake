gg_layer(transport SOURCES directional_form.cpp emitter_sampling.cpp form_factor.cpp form_factor_wide.cpp sky_cell.cpp spherical_rectangle.cpp LINKS gg_scene gg_core)
