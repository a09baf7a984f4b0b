// gg_render_...: starts renders, watches them and hands out their results.
#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

#include "api/convert_settings.h"
#include "api/guard.h"
#include "api/handles.h"

namespace {

// Cuts what is too long, between characters of UTF-8.
template <std::size_t kSize>
void copy_text(const std::string& text, char (&target)[kSize]) {
    std::size_t length = std::min(text.size(), kSize - 1);
    while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) {
        --length;
    }
    std::memcpy(target, text.data(), length);
    target[length] = 0;
}

}  // namespace

gg_status gg_render_start(gg_scene* scene, const gg_camera* camera, const gg_settings* settings, gg_render** render) {
    return gg::guarded([&] {
        gg_scene& source = gg::checked_scene(scene);
        gg::require(settings != nullptr && render != nullptr, "no settings, or no place for the render");
        const gg::RenderSettings converted = gg::convert_settings(camera, *settings);
        auto result = std::make_unique<gg_render>();
        result->job = std::make_unique<gg::RenderJob>(source.cache, converted, source.messages.all());
        source.frozen = true;
        *render = result.release();
    });
}

gg_status gg_render_poll(gg_render* render, gg_progress* progress) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(progress != nullptr, "no place for the progress");
        *progress = source.job->progress();
    });
}

gg_status gg_render_wait(gg_render* render, float seconds) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(seconds >= 0, "seconds are out of range");
        constexpr float kYear = 3e7F;  // what is longer overflows clocks
        source.job->wait(std::chrono::duration<double>(std::min(seconds, kYear)));
    });
}

gg_status gg_render_cancel(gg_render* render) {
    return gg::guarded([&] { gg::checked_render(render).job->cancel(); });
}

const char* gg_render_error(gg_render* render) {
    const char* result = "not a render, or destroyed";
    (void)gg::guarded([&] {
        gg::RenderJob& job = *gg::checked_render(render).job;
        result = job.finished() ? job.outcome().text.c_str() : "";
    });
    return result;
}

void gg_render_destroy(gg_render* render) {
    (void)gg::guarded([&] {
        if (render != nullptr) {
            delete &gg::checked_render(render);
        }
    });
}

gg_status gg_render_next_tile(gg_render* render, gg_tile* tile, int32_t* found) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(tile != nullptr && found != nullptr, "no place for the tile");
        const auto next = source.job->film().next_finished_tile();
        *found = next ? 1 : 0;
        if (next) {
            *tile = {next->x, next->y, next->width, next->height};
        }
    });
}

gg_status gg_render_read(gg_render* render, const char* pass, const gg_tile* rectangle, float* values) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(pass != nullptr, "no pass");
        gg::require(rectangle != nullptr && values != nullptr, "no rectangle, or no place for the values");
        const gg::Rectangle area{rectangle->x, rectangle->y, rectangle->width, rectangle->height};
        const gg::Film& film = source.job->film();
        gg::require(film.contains(area), "the rectangle does not lie within the picture");
        const std::size_t size = std::size_t{area.width} * area.height;
        if (std::strcmp(pass, "Combined") == 0) {
            std::vector<gg::Rgba> pixels(size);
            film.read(area, pixels);
            static_assert(sizeof(gg::Rgba) == 4 * sizeof(float));
            std::memcpy(values, pixels.data(), size * sizeof(gg::Rgba));
            return;
        }
        const auto found = std::find(gg::kPassNames.begin(), gg::kPassNames.end(), std::string_view(pass));
        gg::require(found != gg::kPassNames.end() &&
                        film.read(area, static_cast<gg::Pass>(found - gg::kPassNames.begin()), {values, size}),
                    "a pass that the render does not keep");
    });
}

gg_status gg_render_statistics(gg_render* render, const char** json) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(json != nullptr, "no place for the statistics");
        if (!source.job->finished()) {
            throw gg::Error(GG_WRONG_STATE, "the render has not finished");
        }
        if (source.statistics.empty()) {
            source.statistics = source.job->statistics().json();
        }
        *json = source.statistics.c_str();
    });
}

gg_status gg_render_message(gg_render* render, uint32_t index, gg_message* message, int32_t* found) {
    return gg::guarded([&] {
        gg_render& source = gg::checked_render(render);
        gg::require(message != nullptr && found != nullptr, "no place for the message");
        const std::vector<gg::Message> messages = source.job->messages().all();
        *found = index < messages.size() ? 1 : 0;
        if (*found) {
            copy_text(messages[index].object, message->object);
            copy_text(messages[index].text, message->text);
            message->count = messages[index].count;
        }
    });
}
