#include "gather/shared_light.h"

#include <algorithm>

#include "gather/same_surface.h"

namespace gg {

namespace {

constexpr float kSoft = 1.7F;   // times the tolerance: steps of soft light are those of rays, not of shadows
constexpr float kAlone = 0.1F;  // weight of a neighbour without one across, where a pair has 1

// A fragment of the same surface that has been shaded.
struct Neighbour {
    const PointLight* light = nullptr;
    float weight = 0;  // of all they sum to 1
};

// The pixel's fragment that shows the same surface as `at`, the closest one, or kNone.
std::uint32_t same_surface_in(const TileFragments& tile, int x, int y, const Fragment& at) {
    const int width = static_cast<int>(tile.tile.width), height = static_cast<int>(tile.tile.height);
    if (x < 0 || y < 0 || x >= width || y >= height) {
        return kNone;
    }
    const auto pixel = static_cast<std::size_t>(y * width + x);
    std::uint32_t found = kNone;
    float closest = kInfinity;
    for (std::uint32_t f = tile.begin_of(pixel); f < tile.pixels[pixel].end; ++f) {
        const float square = length_squared(tile.fragments[f].position - at.position);
        if (square < closest && is_same_surface(at, tile.fragments[f])) {
            closest = square;
            found = f;
        }
    }
    return found;
}

class Neighbours {
  public:
    Neighbours(const TileFragments& tile, std::span<const PointLight> light, const SharingStage& stage,
               std::uint32_t pixel, const Fragment& at) {
        const int x = static_cast<int>(pixel % tile.tile.width), y = static_cast<int>(pixel / tile.tile.width);
        float weights = 0;
        const auto add = [&](std::uint32_t f, float weight) {
            found_[count_++] = {&light[f], weight};
            weights += weight;
        };
        for (const SharingStage::Step& step : stage.across) {
            const std::uint32_t before = same_surface_in(tile, x - step.x, y - step.y, at);
            const std::uint32_t after = same_surface_in(tile, x + step.x, y + step.y, at);
            if (before != kNone && after != kNone) {
                const Vec3 from = tile.fragments[before].position, to = tile.fragments[after].position - from;
                const float share =
                    std::clamp(dot(at.position - from, to) / std::max(length_squared(to), 1e-30F), 0.0F, 1.0F);
                add(before, 1 - share);
                add(after, share);
            } else if (before != kNone || after != kNone) {
                add(std::min(before, after), kAlone);
            }
        }
        for (Neighbour& neighbour : found_) {
            neighbour.weight /= std::max(weights, 1e-30F);
        }
    }

    [[nodiscard]] std::span<const Neighbour> all() const { return std::span(found_).first(count_); }
    // On all sides of the fragment.
    [[nodiscard]] bool surround() const { return count_ == found_.size(); }

    [[nodiscard]] Rgb mean_of(Rgb PointLight::*part) const {
        Rgb sum(0.0F);
        for (const Neighbour& neighbour : all()) {
            sum += neighbour.weight * neighbour.light->*part;
        }
        return sum;
    }
    // Of its luminance, W/m2.
    [[nodiscard]] float range_of(Rgb PointLight::*part) const {
        float least = kInfinity, most = -kInfinity;
        for (const Neighbour& neighbour : all()) {
            least = std::min(least, luminance(neighbour.light->*part));
            most = std::max(most, luminance(neighbour.light->*part));
        }
        return most - least;
    }

  private:
    std::array<Neighbour, 4> found_;
    std::size_t count_ = 0;
};

const SeenSender* find(std::span<const SeenSender> senders, NodeId sender) {
    const auto found = std::lower_bound(senders.begin(), senders.end(), sender,
                                        [](const SeenSender& a, NodeId b) { return a.sender < b; });
    return found != senders.end() && found->sender == sender ? &*found : nullptr;
}

// Senders that all neighbours looked at and see alike. allowed: difference of what a sender brings, W/m2.
std::vector<SeenSender> seen_alike(std::span<const Neighbour> around, float allowed) {
    std::vector<SeenSender> alike;
    for (const SeenSender& first : around.front().light->glowing) {
        SeenSender mean{first.sender, 0, 0};
        float least = 1, most = 0;
        const bool everywhere = std::all_of(around.begin(), around.end(), [&](const Neighbour& neighbour) {
            const SeenSender* seen = find(neighbour.light->glowing, first.sender);
            if (seen != nullptr) {
                least = std::min(least, seen->visibility);
                most = std::max(most, seen->visibility);
                mean.visibility += neighbour.weight * seen->visibility;
                mean.unoccluded = std::max(mean.unoccluded, seen->unoccluded);
            }
            return seen != nullptr;
        });
        if (everywhere && (most - least) * mean.unoccluded <= allowed) {
            alike.push_back(mean);
        }
    }
    return alike;
}

// Pixels of a tile so that every aligned square follows on another.
std::uint32_t place_in_squares(std::uint32_t x, std::uint32_t y) {
    std::uint32_t place = 0;
    for (int bit = 0; bit < 16; ++bit) {
        place |= (x >> bit & 1U) << (2 * bit) | (y >> bit & 1U) << (2 * bit + 1);
    }
    return place;
}

}  // namespace

Sharing sharing_in(float cell, float threshold) {
    // Wider only by the root of what pictures grow by: what is shared once more adds its errors.
    constexpr float kPixels = 20;
    Sharing sharing{1, threshold};
    while (static_cast<float>(sharing.spacing * sharing.spacing) * kPixels <= cell) {
        sharing.spacing *= 2;
    }
    return sharing;
}

std::vector<SharingStage> sharing_stages(std::uint32_t width, std::uint32_t height, int spacing) {
    std::vector<SharingStage> stages;
    const auto add = [&](std::vector<SharingStage::Step> across, const auto& belongs) {
        SharingStage stage{{}, std::move(across)};
        for (std::uint32_t p = 0; p < width * height; ++p) {
            if (belongs(static_cast<int>(p % width), static_cast<int>(p / width))) {
                stage.pixels.push_back(p);
            }
        }
        std::sort(stage.pixels.begin(), stage.pixels.end(), [width](std::uint32_t a, std::uint32_t b) {
            return place_in_squares(a % width, a / width) < place_in_squares(b % width, b / width);
        });
        stages.push_back(std::move(stage));
    };
    add({}, [&](int x, int y) { return x % spacing == 0 && y % spacing == 0; });
    for (int half = spacing / 2; half > 0; half /= 2) {
        const auto is_between = [half](int at) { return at % (2 * half) == half; };
        const auto is_known = [half](int at) { return at % (2 * half) == 0; };
        add({{half, half}, {half, -half}}, [&](int x, int y) { return is_between(x) && is_between(y); });
        add({{half, 0}, {0, half}},
            [&](int x, int y) { return (is_between(x) && is_known(y)) || (is_known(x) && is_between(y)); });
    }
    return stages;
}

KnownLight shared_light(const TileFragments& tile, std::span<const PointLight> light, const SharingStage& stage,
                        std::uint32_t pixel, std::uint32_t fragment, float tolerance) {
    const Neighbours around(tile, light, stage, pixel, tile.fragments[fragment]);
    KnownLight known;
    if (around.all().size() < 2) {
        return known;
    }
    const float allowed = tolerance * luminance(around.mean_of(&PointLight::all));
    const auto share = [&](Rgb PointLight::*part, float range, std::optional<Rgb>& out) {
        if (around.range_of(part) <= range) {
            out = around.mean_of(part);
        }
    };
    share(&PointLight::soft, kSoft * allowed, known.soft);
    share(&PointLight::sky, allowed, known.sky);
    // These cast sharp shadows, which may end where the surface does.
    if (around.surround()) {
        known.glowing = seen_alike(around.all(), allowed);
    }
    return known;
}

}  // namespace gg
