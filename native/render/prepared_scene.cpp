#include "render/prepared_scene.h"

#include <chrono>
#include <utility>

#include "core/control.h"
#include "core/statistics.h"
#include "radiosity/solve.h"
#include "scene/build_scene.h"
#include "scene/load_textures.h"

namespace gg {

namespace {

// Waits for another render's work on the same scene, unless cancelled.
std::unique_lock<std::timed_mutex> lock_cache(SceneCache& cache, const Control& control) {
    std::unique_lock lock(cache.mutex, std::defer_lock);
    while (!lock.try_lock_for(std::chrono::milliseconds(20))) {
        control.check_cancel();
    }
    return lock;
}

template <typename T>
std::size_t vector_bytes(const std::vector<T>& values) {
    return values.capacity() * sizeof(T);
}

std::size_t scene_bytes(const Scene& scene) {
    std::size_t bytes = vector_bytes(scene.instances) + vector_bytes(scene.lamps) + vector_bytes(scene.materials);
    for (const Mesh& mesh : scene.meshes) {
        bytes += sizeof(Mesh) + vector_bytes(mesh.positions) + vector_bytes(mesh.triangles) +
                 vector_bytes(mesh.shading_vertices) + vector_bytes(mesh.normals) + vector_bytes(mesh.uvs) +
                 vector_bytes(mesh.slots) + vector_bytes(mesh.sides);
    }
    return bytes;
}

void report(const PreparedScene& prepared, Statistics& statistics) {
    std::size_t triangles = 0;
    std::size_t placed = 0;
    for (const Mesh& mesh : prepared.scene.meshes) {
        triangles += mesh.triangles.size();
    }
    for (const Instance& instance : prepared.scene.instances) {
        placed += prepared.scene.meshes[instance.mesh].triangles.size();
    }
    statistics.set_count("triangles", static_cast<double>(triangles));
    statistics.set_count("placed triangles", static_cast<double>(placed));
    statistics.set_count("instances", static_cast<double>(prepared.scene.instances.size()));
    statistics.set_count("lamps", static_cast<double>(prepared.scene.lamps.size()));
    statistics.set_bytes("scene", static_cast<double>(scene_bytes(prepared.scene)));
    statistics.set_bytes("textures", static_cast<double>(prepared.textures.memory_bytes()));
    statistics.set_bytes("trace", static_cast<double>(prepared.tracer->bytes()));
}

std::shared_ptr<const PreparedScene> build(const SceneDescription& description, Control& control,
                                           Statistics& statistics) {
    const auto result = std::make_shared<PreparedScene>();
    Messages messages;
    {
        control.begin_stage("build scene", 0.05F);
        const StageTimer timer(statistics, "build scene");
        result->scene = build_scene(description, control, messages);
    }
    {
        control.begin_stage("textures", 0.1F);
        const StageTimer timer(statistics, "textures");
        result->textures = load_textures(description, control, messages);
        result->colors.emplace(result->scene, result->textures, messages);
    }
    {
        control.begin_stage("trace: build", 0.15F);
        const StageTimer timer(statistics, "trace: build");
        result->tracer = std::make_unique<RayTracer>(result->scene, control);
    }
    result->messages = messages.all();
    return result;
}

}  // namespace

std::shared_ptr<const PreparedScene> prepare_scene(SceneCache& cache, Control& control, Messages& messages,
                                                   Statistics& statistics) {
    const auto lock = lock_cache(cache, control);
    if (!cache.prepared) {
        cache.prepared = build(cache.description, control, statistics);
        cache.description = {};
    }
    for (const Message& message : cache.prepared->messages) {
        messages.add(message.object, message.text, message.count);
    }
    report(*cache.prepared, statistics);
    return cache.prepared;
}

std::shared_ptr<const Solution> solve_lighting(SceneCache& cache, const PreparedScene& prepared, float quality,
                                               Control& control, Statistics& statistics) {
    const auto lock = lock_cache(cache, control);
    std::shared_ptr<const Solution>& solution = cache.solutions[quality];
    if (!solution) {
        solution =
            solve(prepared.scene, *prepared.colors, *prepared.tracer, SolveSettings{quality}, control, statistics);
    }
    return solution;
}

}  // namespace gg
