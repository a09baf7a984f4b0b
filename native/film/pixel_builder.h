// One pixel's samples, sorted into fragments.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "trace/surface_point.h"

namespace gg {

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
    Range reflecting;      // what fragments reflect, if that is expected
    bool several = false;  // fragments
};

// One pixel after the other.
class PixelBuilder {
  public:
    // irradiance_at: null where fragments are wanted. expected: about how light they are, or null. Pixels and their
    // fragments are added to `out`.
    PixelBuilder(const View& view, const IrradianceAt* irradiance_at, const IrradianceAt* expected, TileFragments& out)
        : view_(view), irradiance_at_(irradiance_at), expected_(expected), out_(out) {}

    Variety add(std::span<const Ray> rays, std::span<const Hit> hits);

    // Parts of the fragments instead; see divide_pixel().
    [[nodiscard]] std::vector<FragmentPart> divide(std::span<const Ray> rays, std::span<const Hit> hits, int halvings);

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

    std::uint32_t collect(std::span<const Ray> rays, std::span<const Hit> hits, PixelFragments& pixel);
    bool add_sample(const Ray& ray, const Hit& hit, PixelFragments& pixel);
    Part& part_of(const Place& place, bool back);
    static std::size_t halve(std::span<Place> places);
    static void divide(std::span<Place> places, int halvings, const FragmentPart& whole, float share,
                       std::vector<FragmentPart>& out);
    static Fragment fragment_of(std::span<const Place> places, Fragment fragment, float share);

    const View& view_;
    const IrradianceAt* irradiance_at_;
    const IrradianceAt* expected_;
    TileFragments& out_;
    std::vector<Part> parts_;
    Variety variety_;
    float share_ = 0;  // of a sample
};

}  // namespace gg
