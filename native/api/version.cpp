#include "gridgather.h"

uint32_t gg_interface_version(void) {
    return GG_INTERFACE_VERSION;
}

const char* gg_version(void) {
    return GG_VERSION " (Embree " GG_EMBREE_VERSION ", OpenImageIO " GG_OIIO_VERSION ")";
}
