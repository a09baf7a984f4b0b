#include "trace/embree_scene.h"

#include <cstdint>
#include <span>

#include "core/control.h"
#include "core/error.h"
#include "core/parallel.h"
#include "scene/scene.h"

namespace gg {

namespace {

// A copy of so small a mesh is cheaper than an instance of it: for Embree an instance is a node, a transform and a
// scene.
constexpr std::size_t kSmallMesh = 32;

void on_error(void* user, RTCError code, const char* text) {
    if (code == RTC_ERROR_CANCELLED) {
        return;
    }
    auto& reports = *static_cast<EmbreeReports*>(user);
    const std::lock_guard lock(reports.mutex);
    if (reports.error == RTC_ERROR_NONE) {
        reports.error = code;
        reports.text = text != nullptr ? text : "";
    }
}

bool on_memory(void* user, ssize_t bytes, bool) {
    static_cast<EmbreeReports*>(user)->bytes.fetch_add(bytes, std::memory_order_relaxed);
    return true;
}

bool on_progress(void* user, double) {
    return !static_cast<const Control*>(user)->cancelled();
}

void check_errors(EmbreeReports& reports) {
    const std::lock_guard lock(reports.mutex);
    if (reports.error != RTC_ERROR_NONE) {
        const bool memory = reports.error == RTC_ERROR_OUT_OF_MEMORY;
        throw Error(memory ? GG_OUT_OF_MEMORY : GG_INTERNAL_ERROR, "Embree: " + reports.text);
    }
}

OwnedScene make_scene(RTCDevice device, const Control& control) {
    OwnedScene scene(rtcNewScene(device));
    // Rays must not slip through shared edges of closed rooms.
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    // Embree's signature wants a mutable pointer; on_progress reads only.
    rtcSetSceneProgressMonitorFunction(scene.get(), on_progress, const_cast<Control*>(&control));
    return scene;
}

void commit(RTCScene scene) {
    rtcCommitScene(scene);
    // The function's Control dies before the scene.
    rtcSetSceneProgressMonitorFunction(scene, nullptr, nullptr);
}

// Vertices are copied: Embree reads 16 bytes for each, beyond the end of a packed array.
OwnedGeometry make_triangles(RTCDevice device, const Mesh& mesh, const Affine& placement) {
    OwnedGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = static_cast<Vec3*>(rtcSetNewGeometryBuffer(
        geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), mesh.positions.size()));
    if (vertices == nullptr) {
        throw Error(GG_OUT_OF_MEMORY, "no memory for the vertices of " + mesh.name);
    }
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        vertices[vertex] = placement.point(mesh.positions[vertex]);
    }
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(TriangleCorners), mesh.triangles.size());
    return geometry;
}

OwnedGeometry make_instance(RTCDevice device, RTCScene mesh, const Affine& placement) {
    OwnedGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(geometry.get(), mesh);
    const float columns[12] = {placement.linear[0].x,   placement.linear[0].y,   placement.linear[0].z,
                               placement.linear[1].x,   placement.linear[1].y,   placement.linear[1].z,
                               placement.linear[2].x,   placement.linear[2].y,   placement.linear[2].z,
                               placement.translation.x, placement.translation.y, placement.translation.z};
    rtcSetGeometryTransform(geometry.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    return geometry;
}

// Embree inverts an instance's transform. A volume factor next to nothing has no inverse that is of use.
bool invertible(const Mat3& linear) {
    const double size = static_cast<double>(length(linear[0])) * length(linear[1]) * length(linear[2]);
    return std::abs(static_cast<double>(glm::determinant(linear))) > 1e-6 * size && size > 1e-30;
}

bool placed_as_instance(const Scene& scene, const Instance& instance, std::span<const std::uint32_t> uses) {
    return uses[instance.mesh] > 1 && scene.meshes[instance.mesh].triangles.size() > kSmallMesh &&
           invertible(instance.to_world.linear);
}

unsigned mask_of(const Instance& instance) {
    return (instance.flags & GG_HIDDEN_FROM_CAMERA ? 0U : 1U) | (instance.flags & GG_HIDDEN_FROM_LIGHT ? 0U : 2U);
}

}  // namespace

void build_embree_scene(const Scene& scene, const Control& control, EmbreeScene& result) {
    result.device.reset(rtcNewDevice(nullptr));
    if (!result.device) {
        throw Error(GG_INTERNAL_ERROR, "Embree does not start on this machine");
    }
    RTCDevice device = result.device.get();
    rtcSetDeviceErrorFunction(device, on_error, &result.reports);
    rtcSetDeviceMemoryMonitorFunction(device, on_memory, &result.reports);

    std::vector<std::uint32_t> uses(scene.meshes.size(), 0);
    for (const Instance& instance : scene.instances) {
        ++uses[instance.mesh];
    }
    std::vector<bool> is_shared(scene.meshes.size(), false);
    for (const Instance& instance : scene.instances) {
        is_shared[instance.mesh] = is_shared[instance.mesh] || placed_as_instance(scene, instance, uses);
    }
    result.shared_meshes.resize(scene.meshes.size());
    parallel_for(scene.meshes.size(), 1, control, [&](std::size_t index) {
        if (!is_shared[index]) {
            return;
        }
        const OwnedGeometry geometry = make_triangles(device, scene.meshes[index], Affine{});
        rtcSetGeometryMask(geometry.get(), 3);
        rtcCommitGeometry(geometry.get());
        OwnedScene mesh = make_scene(device, control);
        rtcAttachGeometry(mesh.get(), geometry.get());
        commit(mesh.get());
        result.shared_meshes[index] = std::move(mesh);
    });
    check_errors(result.reports);

    std::vector<OwnedGeometry> geometries(scene.instances.size());
    parallel_for(scene.instances.size(), 16, control, [&](std::size_t index) {
        const Instance& instance = scene.instances[index];
        geometries[index] = placed_as_instance(scene, instance, uses)
                                ? make_instance(device, result.shared_meshes[instance.mesh].get(), instance.to_world)
                                : make_triangles(device, scene.meshes[instance.mesh], instance.to_world);
        rtcSetGeometryMask(geometries[index].get(), mask_of(instance));
        rtcCommitGeometry(geometries[index].get());
    });
    result.top = make_scene(device, control);
    for (std::size_t index = 0; index < geometries.size(); ++index) {
        rtcAttachGeometryByID(result.top.get(), geometries[index].get(), static_cast<unsigned>(index));
    }
    commit(result.top.get());
    control.check_cancel();
    check_errors(result.reports);
}

}  // namespace gg
