gg_layer(image SOURCES mip_pyramid.cpp read_image.cpp texel_codec.cpp texture.cpp
         LINKS gg_core ${OIIO_LIBRARY} ${OIIO_UTIL_LIBRARY})
target_include_directories(gg_image SYSTEM PRIVATE ${OIIO_INCLUDE})
