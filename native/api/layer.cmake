gg_layer(api
         SOURCES convert_scene.cpp convert_settings.cpp display_api.cpp guard.cpp processor.cpp render_api.cpp render_job.cpp
                 scene_api.cpp version.cpp
         LINKS gg_render gg_core)
# Runs before anything else may: on any x86-64.
set_source_files_properties(api/processor.cpp PROPERTIES COMPILE_OPTIONS -march=x86-64)

file(STRINGS ${OIIO_INCLUDE}/OpenImageIO/oiioversion.h oiio_numbers REGEX "define OIIO_VERSION_(MAJOR|MINOR|PATCH) ")
string(REGEX REPLACE ".*MAJOR +([0-9]+).*MINOR +([0-9]+).*PATCH +([0-9]+).*" "\\1.\\2.\\3" oiio_version
       "${oiio_numbers}")
set_source_files_properties(api/version.cpp PROPERTIES COMPILE_DEFINITIONS
  "GG_VERSION=\"${PROJECT_VERSION}\";GG_EMBREE_VERSION=\"${embree_VERSION}\";GG_OIIO_VERSION=\"${oiio_version}\"")
