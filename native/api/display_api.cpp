// gg_display_...: what displays show.
#include "api/convert_settings.h"
#include "api/guard.h"

gg_status gg_display_encode(const gg_display* display, float* pixels, uint64_t count) {
    return gg::guarded([&] {
        gg::require(display != nullptr && (pixels != nullptr || count == 0), "no display or no pixels");
        gg::require(count <= (1ULL << 32), "too many pixels");
        const gg::DisplayTransform transform(gg::convert_display(*display));
        if (!transform.failure().empty()) {
            throw gg::Error(GG_INVALID_ARGUMENT, transform.failure());
        }
        std::vector<gg::Rgb> colors(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            colors[i] = {pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]};
        }
        transform.encode(colors);
        for (std::uint64_t i = 0; i < 3 * count; ++i) {
            pixels[i] = colors[i / 3][static_cast<int>(i % 3)];
        }
    });
}
