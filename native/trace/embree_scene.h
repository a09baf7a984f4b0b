// Embree's picture of a scene. Geometry ids of `top` are indices into Scene::instances, whether an instance is an
// Embree instance of a shared mesh or a mesh of its own in world space.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <vector>

#include "trace/embree_api.h"

namespace gg {

class Control;
struct Scene;

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using OwnedDevice = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using OwnedScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using OwnedGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

// What Embree reports from any thread.
struct EmbreeReports {
    std::atomic<std::ptrdiff_t> bytes{0};
    std::mutex mutex;
    RTCError error = RTC_ERROR_NONE;  // the first, cancels apart
    std::string text;
};

struct EmbreeScene {
    EmbreeReports reports;  // outlives the device
    OwnedDevice device;
    std::vector<OwnedScene> shared_meshes;  // by mesh; null: placed in `top` directly
    OwnedScene top;
};

// Throws Cancelled, or Error when Embree fails. The scene's triangle arrays are shared, not copied.
void build_embree_scene(const Scene& scene, const Control& control, EmbreeScene& result);

}  // namespace gg
