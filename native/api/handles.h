// What the opaque handles point to. A handle that was destroyed, or never was one, is told by its magic number: no
// promise, as its memory may be gone, but it turns most mistakes into errors.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "api/guard.h"
#include "api/render_job.h"
#include "core/messages.h"
#include "gridgather.h"
#include "render/prepared_scene.h"

struct gg_scene {
    static constexpr std::uint64_t kMagic = 0x67675f7363656e65ULL;
    volatile std::uint64_t magic = kMagic;
    bool frozen = false;  // by the first render
    gg::SceneCache cache;
    gg::Messages messages;                                               // the caller's own
    std::map<std::vector<std::uint32_t>, std::uint32_t> material_lists;  // -> index in the description

    ~gg_scene() { magic = 0; }
};

struct gg_render {
    static constexpr std::uint64_t kMagic = 0x67675f72656e6472ULL;
    volatile std::uint64_t magic = kMagic;
    std::unique_ptr<gg::RenderJob> job;
    std::string statistics;  // what gg_render_statistics lent out

    ~gg_render() { magic = 0; }
};

namespace gg {

// Throws Error(GG_INVALID_ARGUMENT) for null and for what is not a handle of this kind.
template <typename Handle>
[[nodiscard]] Handle& checked(Handle* handle, const char* what) {
    if (handle == nullptr || reinterpret_cast<std::uintptr_t>(handle) % alignof(Handle) != 0 ||
        handle->magic != Handle::kMagic) {
        throw Error(GG_INVALID_ARGUMENT, what);
    }
    return *handle;
}

[[nodiscard]] inline gg_scene& checked_scene(gg_scene* scene) {
    return checked(scene, "not a scene, or destroyed");
}
[[nodiscard]] inline gg_render& checked_render(gg_render* render) {
    return checked(render, "not a render, or destroyed");
}

}  // namespace gg
