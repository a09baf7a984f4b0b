#include "film/fragments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "film/sample_color.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kSameNormal = 0.97F;  // cosine of the largest angle within a fragment
// Times the samples: where surfaces or colours change, and where something that shines ends in a pixel or beside it.
constexpr std::uint32_t kBorderSamples = 4, kEdgeSamples = 8;
constexpr float kEvenColor = 1.25F;  // ratio of a pixel's brightest albedo to its darkest
constexpr float kSamePlane = 2;      // largest distance from a fragment's plane, in pixels

std::uint64_t pixel_id(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{y} << 32 | x;
}

// From the darkest to the brightest of some samples, luminance.
struct Range {
    float darkest = kInfinity, brightest = 0;

    void add(Rgb color) { add({luminance(color), luminance(color)}); }
    void add(const Range& other) {
        darkest = std::min(darkest, other.darkest);
        brightest = std::max(brightest, other.brightest);
    }
    [[nodiscard]] bool exceeds(float ratio) const { return brightest > ratio * darkest; }
};

// What a pixel's samples found.
struct Variety {
    Range shining, albedo;
    bool several = false;  // fragments

    [[nodiscard]] bool has_borders() const { return several || albedo.exceeds(kEvenColor); }
};

// One pixel after the other.
class PixelBuilder {
  public:
    // irradiance_at: null where fragments are wanted.
    PixelBuilder(const View& view, const IrradianceAt* irradiance_at, TileFragments& out)
        : view_(view), irradiance_at_(irradiance_at), out_(out) {}

    Variety add(std::span<const Ray> rays, std::span<const Hit> hits) {
        PixelFragments pixel;
        pixel.samples = static_cast<std::uint32_t>(rays.size());
        const std::uint32_t kept = collect(rays, hits, pixel);
        const float share = 1 / static_cast<float>(rays.size());
        pixel.emitted *= share;
        pixel.alpha *= share;
        pixel.kept = share * static_cast<float>(kept);
        for (const Part& part : parts_) {
            out_.fragments.push_back(fragment_of(part.places, part.fragment, share));
        }
        pixel.end = static_cast<std::uint32_t>(out_.fragments.size());
        out_.pixels.push_back(pixel);
        variety_.several = parts_.size() > 1;
        return variety_;
    }

    [[nodiscard]] std::vector<FragmentPart> divide(std::span<const Ray> rays, std::span<const Hit> hits, int halvings) {
        PixelFragments pixel;
        collect(rays, hits, pixel);
        const float share = 1 / static_cast<float>(rays.size());
        std::vector<FragmentPart> result;
        for (std::uint32_t k = 0; k < parts_.size(); ++k) {
            divide(parts_[k].places, halvings, {parts_[k].fragment, k}, share, result);
        }
        return result;
    }

  private:
    struct Place {
        Hit hit;
        SurfacePoint point;  // of the side that is seen
        Rgb albedo{0.0F};
    };
    struct Part {
        Fragment fragment;
        float tolerance = 0;  // m from the plane of the first place
        std::vector<Place> places;
    };

    // Sorts samples into parts. Returns how many are finite.
    std::uint32_t collect(std::span<const Ray> rays, std::span<const Hit> hits, PixelFragments& pixel) {
        parts_.clear();
        variety_ = {};
        std::uint32_t kept = 0;
        for (std::size_t sample = 0; sample < rays.size(); ++sample) {
            kept += add_sample(rays[sample], hits[sample], pixel) ? 1 : 0;
        }
        return kept;
    }

    // False for a sample that is not finite.
    bool add_sample(const Ray& ray, const Hit& hit, PixelFragments& pixel) {
        if (hit.missed()) {
            variety_.shining.add(view_.settings.film_transparent ? Rgb(0.0F) : view_.scene.world);
            if (!view_.settings.film_transparent) {
                pixel.emitted += view_.scene.world;
                pixel.alpha += 1;
            }
            return true;
        }
        Place place{hit, surface_point(view_.scene, hit), Rgb(0.0F)};
        const bool back = dot(place.point.geometric_normal, ray.direction) > 0;
        if (back) {
            place.point.geometric_normal = -place.point.geometric_normal;
            place.point.shading_normal = -place.point.shading_normal;
        }
        const SampleColors colors = colors_at(view_, ray, hit);
        if (!is_finite(colors.albedo) || !is_finite(colors.emission)) {
            return false;
        }
        if (irradiance_at_ != nullptr) {
            const Rgb reflected = colors.albedo * (*irradiance_at_)(hit, back) / kPi;
            if (!is_finite(reflected)) {
                return false;
            }
            pixel.emitted += reflected;
        }
        variety_.shining.add(colors.emission);
        variety_.albedo.add(colors.albedo);
        pixel.emitted += colors.emission;
        pixel.alpha += 1;
        if (irradiance_at_ != nullptr) {
            return true;
        }
        Part& part = part_of(place, back);
        place.albedo = colors.albedo;
        part.places.push_back(place);
        return true;
    }

    Part& part_of(const Place& place, bool back) {
        for (Part& part : parts_) {
            const Place& first = part.places.front();
            if (part.fragment.hit.instance == place.hit.instance && part.fragment.back == back &&
                dot(first.point.shading_normal, place.point.shading_normal) > kSameNormal &&
                std::abs(dot(place.point.position - first.point.position, first.point.geometric_normal)) <
                    part.tolerance) {
                return part;
            }
        }
        parts_.emplace_back();
        parts_.back().fragment.hit = place.hit;
        parts_.back().fragment.back = back;
        parts_.back().tolerance = kSamePlane * view_.camera.pixel_size(place.hit.distance);
        return parts_.back();
    }

    // Orders places along the axis on which they spread most. Returns where the second half begins.
    static std::size_t halve(std::span<Place> places) {
        Box box;
        for (const Place& place : places) {
            box.extend(place.point.position);
        }
        const Vec3 extent = box.upper - box.lower;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        std::stable_sort(places.begin(), places.end(), [axis](const Place& a, const Place& b) {
            return a.point.position[axis] < b.point.position[axis];
        });
        return places.size() / 2;
    }

    void divide(std::span<Place> places, int halvings, const FragmentPart& whole, float share,
                std::vector<FragmentPart>& out) const {
        if (places.empty()) {
            return;
        }
        if (halvings == 0) {
            out.push_back({fragment_of(places, whole.at, share), whole.fragment});
            return;
        }
        const std::size_t half = halve(places);
        divide(places.first(half), halvings - 1, whole, share, out);
        divide(places.subspan(half), halvings - 1, whole, share, out);
    }

    // The place next to the middle stands for all. share: of a place.
    static Fragment fragment_of(std::span<const Place> places, Fragment fragment, float share) {
        Vec3 middle(0.0F);
        fragment.albedo = Rgb(0.0F);
        for (const Place& place : places) {
            middle += place.point.position / static_cast<float>(places.size());
            fragment.albedo += share * place.albedo;
        }
        const auto distance = [&](const Place& place) { return length_squared(place.point.position - middle); };
        const Place& best = *std::min_element(
            places.begin(), places.end(), [&](const Place& a, const Place& b) { return distance(a) < distance(b); });
        fragment.share = share * static_cast<float>(places.size());
        fragment.hit = best.hit;
        fragment.position = best.point.position;
        fragment.normal = best.point.geometric_normal;
        fragment.shading_normal = best.point.shading_normal;
        return fragment;
    }

    const View& view_;
    const IrradianceAt* irradiance_at_;
    TileFragments& out_;
    std::vector<Part> parts_;
    Variety variety_;
};

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
    TileTracer(const View& view, const Rectangle& tile, const IrradianceAt* irradiance_at)
        : view_(view),
          irradiance_at_(irradiance_at),
          x_(static_cast<int>(view.settings.crop.x + tile.x)),
          y_(static_cast<int>(view.settings.crop.y + tile.y)),
          width_(static_cast<int>(tile.width)),
          height_(static_cast<int>(tile.height)) {
        first_.tile = tile;
    }

    TileFragments trace() {
        const std::uint32_t samples = view_.settings.samples;
        TileFragments unused, result;
        PixelBuilder inner(view_, irradiance_at_, first_), outer(view_, irradiance_at_, unused);
        for (int row = -1; row <= height_; ++row) {
            for (int column = -1; column <= width_; ++column) {
                const bool inside = row >= 0 && row < height_ && column >= 0 && column < width_;
                found_.push_back(add(inside ? inner : outer, row, column, samples));
            }
        }
        result.tile = first_.tile;
        PixelBuilder closer(view_, irradiance_at_, result);
        for (int row = 0; row < height_; ++row) {
            for (int column = 0; column < width_; ++column) {
                if (shining_ends_near(row, column)) {
                    add(closer, row, column, kEdgeSamples * samples);
                } else if (found(row, column).has_borders()) {
                    add(closer, row, column, kBorderSamples * samples);
                } else {
                    copy(static_cast<std::size_t>(row) * width_ + column, result);
                }
            }
        }
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

    // Few samples of a pixel may miss what is at its rim, and a lamp counts there, too: so those beside it say what
    // ends.
    [[nodiscard]] bool shining_ends_near(int row, int column) const {
        constexpr float kEven = 2;
        Range around;
        for (int i = 0; i < 9; ++i) {
            around.add(found(row + i / 3 - 1, column + i % 3 - 1).shining);
        }
        return around.exceeds(kEven);
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
    int x_, y_, width_, height_;
    TileFragments first_;
    std::vector<Variety> found_;  // with a rim of one pixel
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
};

}  // namespace

TileFragments trace_tile(const View& view, const Rectangle& tile) {
    return TileTracer(view, tile, nullptr).trace();
}

TileFragments trace_lit_tile(const View& view, const Rectangle& tile, const IrradianceAt& irradiance_at) {
    return TileTracer(view, tile, &irradiance_at).trace();
}

std::vector<FragmentPart> divide_pixel(const View& view, const TileFragments& tile, std::size_t pixel, int halvings) {
    const auto at = static_cast<std::uint32_t>(pixel);
    std::vector<Ray> rays(tile.pixels[pixel].samples);
    std::vector<Hit> hits(rays.size());
    add_rays(view, static_cast<int>(view.settings.crop.x + tile.tile.x + at % tile.tile.width),
             static_cast<int>(view.settings.crop.y + tile.tile.y + at / tile.tile.width), rays);
    view.tracer.closest_hits(rays, hits, RayMask::kCamera, Coherence::kCoherent);
    TileFragments unused;
    return PixelBuilder(view, nullptr, unused).divide(rays, hits, halvings);
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
