// The same scene gives the same bytes for any number of threads, run after run.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

struct Values {
    std::vector<Rgb> radiosities, irradiances;
};

Values solve_with(int threads) {
    Values values;
    run_with_threads(threads, [&] {
        Prepared prepared(mixed_scene());
        const auto solution = prepared.solve(0.02F);
        for (NodeId id = 0; id < solution->hierarchy.nodes().size(); ++id) {
            values.radiosities.push_back(solution->lighting.radiosity(id));
        }
        for (std::uint32_t instance = 0; instance < prepared.scene.instances.size(); ++instance) {
            const auto& mesh = prepared.scene.meshes[prepared.scene.instances[instance].mesh];
            for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
                const Sequence4 sequence(triangle);
                for (std::uint32_t i = 0; i < 16; ++i) {
                    const Vec3 w = square_to_triangle(sequence(i, 0), sequence(i, 1));
                    values.irradiances.push_back(
                        interpolated_irradiance(*solution, instance, triangle, i % 2 == 1, {w.y, w.z}));
                }
            }
        }
    });
    return values;
}

bool same_bytes(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Rgb)) == 0;
}

TEST(ThreadCount, changes_no_byte_of_a_solution) {
    const Values one = solve_with(1);
    ASSERT_GT(one.radiosities.size(), 1000U);
    for (const int threads : {1, 2, 7}) {
        const Values other = solve_with(threads);
        EXPECT_TRUE(same_bytes(one.radiosities, other.radiosities)) << threads << " threads";
        EXPECT_TRUE(same_bytes(one.irradiances, other.irradiances)) << threads << " threads";
    }
}

}  // namespace
}  // namespace gg::test
