gg_layer(image SOURCES display_transform.cpp mip_pyramid.cpp read_image.cpp texel_codec.cpp texture.cpp view_curves.cpp
         LINKS gg_core ${OIIO_LIBRARY} ${OIIO_UTIL_LIBRARY} ${OCIO_LIBRARY})
target_include_directories(gg_image SYSTEM PRIVATE ${OIIO_INCLUDE} ${OCIO_INCLUDE})
