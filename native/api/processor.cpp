// Compiled for every x86-64, see layer.cmake: keep other headers out, or their inline functions come along.
#include "gridgather.h"

int gg_processor_supported(void) {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                   __builtin_cpu_supports("bmi2")
               ? 1
               : 0;
}
