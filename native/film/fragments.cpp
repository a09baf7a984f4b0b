#include "film/fragments.h"

#include <algorithm>
#include <cmath>

#include "film/pixel_builder.h"

namespace gg {

namespace {

// Times the samples: where surfaces or colours change, and where something that shines ends in a pixel or beside it, or
// surfaces are unlike in light.
constexpr std::uint32_t kBorderSamples = 4, kEdgeSamples = 8;
constexpr float kEvenColor = 1.25F;  // ratio of a pixel's brightest albedo to its darkest
constexpr float kEvenLight = 3;      // of its brightest fragment to its darkest

std::uint64_t pixel_id(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{y} << 32 | x;
}

bool has_borders(const Variety& found) {
    return found.several || found.albedo.exceeds(kEvenColor);
}

// x, y: of a pixel, counted in the full picture: a crop shows what the full picture shows.
void add_rays(const View& view, int x, int y, std::span<Ray> rays) {
    const std::uint64_t pixel = pixel_id(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    for (std::uint32_t sample = 0; sample < rays.size(); ++sample) {
        const Vec2 offset = view.filter.offset(pixel, sample);
        rays[sample] =
            view.camera.ray(static_cast<float>(x) + 0.5F + offset.x, static_cast<float>(y) + 0.5F + offset.y);
    }
}

// Pixels of a tile, and what shines in them and in those around the tile.
class TileTracer {
  public:
    TileTracer(const View& view, const Rectangle& tile, const IrradianceAt* irradiance_at, const IrradianceAt* expected)
        : view_(view),
          irradiance_at_(irradiance_at),
          expected_(expected),
          x_(static_cast<int>(view.settings.crop.x + tile.x)),
          y_(static_cast<int>(view.settings.crop.y + tile.y)),
          width_(static_cast<int>(tile.width)),
          height_(static_cast<int>(tile.height)) {
        first_.tile = tile;
    }

    TileFragments trace() {
        const std::uint32_t samples = view_.settings.samples;
        TileFragments unused, result;
        PixelBuilder inner(view_, irradiance_at_, expected_, first_), outer(view_, irradiance_at_, expected_, unused);
        for (int row = -1; row <= height_; ++row) {
            for (int column = -1; column <= width_; ++column) {
                const bool inside = row >= 0 && row < height_ && column >= 0 && column < width_;
                found_.push_back(add(inside ? inner : outer, row, column, samples));
            }
        }
        result.tile = first_.tile;
        PixelBuilder closer(view_, irradiance_at_, nullptr, result);
        for (int row = 0; row < height_; ++row) {
            for (int column = 0; column < width_; ++column) {
                if (light_ends_near(row, column)) {
                    add(closer, row, column, kEdgeSamples * samples);
                } else if (has_borders(found(row, column))) {
                    add(closer, row, column, kBorderSamples * samples);
                } else {
                    copy(static_cast<std::size_t>(row) * width_ + column, result);
                }
            }
        }
        result.pixels.shrink_to_fit();
        result.fragments.shrink_to_fit();
        return result;
    }

  private:
    Variety add(PixelBuilder& builder, int row, int column, std::uint32_t samples) {
        rays_.resize(samples);
        hits_.resize(samples);
        add_rays(view_, x_ + column, y_ + row, rays_);
        view_.tracer.closest_hits(rays_, hits_, RayMask::kCamera, Coherence::kCoherent);
        return builder.add(rays_, hits_);
    }

    // Few samples of a pixel may miss what is at its rim, and what is bright counts there, too: so those beside it say
    // what ends.
    [[nodiscard]] bool light_ends_near(int row, int column) const {
        constexpr float kEvenShining = 2;
        Range shining, reflecting;
        for (int i = 0; i < 9; ++i) {
            const Variety& beside = found(row + i / 3 - 1, column + i % 3 - 1);
            shining.add(beside.shining);
            reflecting.add(beside.reflecting);
        }
        return shining.exceeds(kEvenShining) || reflecting.exceeds(kEvenLight);
    }

    [[nodiscard]] const Variety& found(int row, int column) const {
        return found_[static_cast<std::size_t>(row + 1) * (width_ + 2) + column + 1];
    }

    void copy(std::size_t pixel, TileFragments& to) const {
        PixelFragments copied = first_.pixels[pixel];
        const auto begin = first_.fragments.begin();
        to.fragments.insert(to.fragments.end(), begin + first_.begin_of(pixel), begin + copied.end);
        copied.end = static_cast<std::uint32_t>(to.fragments.size());
        to.pixels.push_back(copied);
    }

    const View& view_;
    const IrradianceAt* irradiance_at_;
    const IrradianceAt* expected_;
    int x_, y_, width_, height_;
    TileFragments first_;
    std::vector<Variety> found_;  // with a rim of one pixel
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
};

}  // namespace

TileFragments trace_tile(const View& view, const Rectangle& tile, const IrradianceAt* expected) {
    return TileTracer(view, tile, nullptr, expected).trace();
}

TileFragments trace_lit_tile(const View& view, const Rectangle& tile, const IrradianceAt& irradiance_at) {
    return TileTracer(view, tile, &irradiance_at, nullptr).trace();
}

std::vector<FragmentPart> divide_pixel(const View& view, const TileFragments& tile, std::size_t pixel, int halvings) {
    const auto at = static_cast<std::uint32_t>(pixel);
    std::vector<Ray> rays(tile.pixels[pixel].samples);
    std::vector<Hit> hits(rays.size());
    add_rays(view, static_cast<int>(view.settings.crop.x + tile.tile.x + at % tile.tile.width),
             static_cast<int>(view.settings.crop.y + tile.tile.y + at / tile.tile.width), rays);
    view.tracer.closest_hits(rays, hits, RayMask::kCamera, Coherence::kCoherent);
    TileFragments unused;
    return PixelBuilder(view, nullptr, nullptr, unused).divide(rays, hits, halvings);
}

std::uint64_t resolve_tile(const View& view, const TileFragments& tile, std::span<const Rgb> irradiance,
                           std::span<Rgba> pixels) {
    float dropped = 0;  // pixels
    for (std::size_t p = 0; p < tile.pixels.size(); ++p) {
        const PixelFragments& pixel = tile.pixels[p];
        Rgb color = pixel.emitted;
        float kept = pixel.kept;
        for (std::uint32_t f = tile.begin_of(p); f < pixel.end; ++f) {
            const Rgb reflected = tile.fragments[f].albedo * irradiance[f] / kPi;
            if (is_finite(reflected)) {
                color += reflected;
            } else {
                kept -= tile.fragments[f].share;
            }
        }
        // What remains is less than a sample only by rounding.
        const bool any = kept * static_cast<float>(pixel.samples) > 0.5F;
        pixels[p] = any ? Rgba{color * (view.settings.exposure / kept), std::min(pixel.alpha / kept, 1.0F)} : Rgba{};
        dropped += 1 - kept;
    }
    return static_cast<std::uint64_t>(std::lround(dropped * static_cast<float>(view.settings.samples)));
}

}  // namespace gg
