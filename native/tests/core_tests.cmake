gg_test(core_tests
        SOURCES core/control_test.cpp core/distance_test.cpp core/messages_test.cpp core/parallel_test.cpp core/pool_test.cpp core/random_test.cpp
                core/statistics_test.cpp core/vec_test.cpp
        LAYERS core)
