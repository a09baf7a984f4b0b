#include "gather/light_tiles.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "gather/light_jumps.h"
#include "gather/pixel_map.h"

namespace gg {

namespace {

constexpr std::size_t kFragmentsAtOnce = 32;  // neighbours, whose rays go together
constexpr int kHalvings = 2;                  // of fragments in which light jumps
constexpr float kLargeJump = 0.7F;            // step to a pixel beside, from which small parts are looked at at once
constexpr float kQuartersJump = 0.5F;         // of the pixel's light, between parts that are divided further

void report(const GatherCounts& total, Statistics& statistics) {
    statistics.set_count("gathered points", static_cast<double>(total.points));
    statistics.set_count("of these by surfaces' own sites", total.on_surface);
    statistics.set_count("resampled senders", static_cast<double>(total.senders));
    statistics.set_count("form factors", static_cast<double>(total.form_factors));
    statistics.set_count("visibility rays", static_cast<double>(total.visibility_rays));
    statistics.set_count("near rays", static_cast<double>(total.near_rays));
    statistics.add_seconds("shading: visibility", total.visibility_seconds / thread_count());
}

// What all points of a pixel took.
struct PixelCounts {
    std::uint32_t points = 0;
    PointCounts sum;

    void add(const PointCounts& taken) {
        ++points;
        sum.visibility_rays += taken.visibility_rays;
        sum.form_factors += taken.form_factors;
        sum.senders += taken.senders;
        sum.on_surface += taken.on_surface;
    }
};

struct LitTile {
    TileLight light;
    std::vector<Rgb> soft;           // PointLight::soft of every fragment
    std::vector<PixelCounts> taken;  // per pixel
    std::uint64_t shared = 0;        // fragments that take their soft light from others
};

class TileLighter {
  public:
    TileLighter(const View& view, const TileFragments& tile, Gatherer& gatherer, LitTile& lit, const Control& control)
        : view_(view), tile_(tile), gatherer_(gatherer), lit_(lit), control_(control) {}

    void light_fragments(const Sharing& sharing) {
        lit_.taken.resize(tile_.pixels.size());
        std::vector<PointLight> light(tile_.fragments.size());
        for (const SharingStage& stage : sharing_stages(tile_.tile.width, tile_.tile.height, sharing.spacing)) {
            light_stage(stage, sharing.tolerance, light);
        }
        lit_.light.reserve(light.size());
        lit_.soft.reserve(light.size());
        for (const PointLight& of_fragment : light) {
            lit_.light.push_back(of_fragment.all);
            lit_.soft.push_back(of_fragment.soft);
        }
    }

    // The light of a pixel's fragments as the mean over their parts; where quarters differ much, over parts of these.
    void light_parts(std::span<const JumpingFragment> of_pixel) {
        control_.check_cancel();
        const std::uint32_t pixel = of_pixel.front().pixel;
        float seen = kPi * luminance(tile_.pixels[pixel].emitted);
        for (std::uint32_t f = tile_.begin_of(pixel); f < tile_.pixels[pixel].end; ++f) {
            seen += luminance(tile_.fragments[f].albedo * lit_.light[f]);
        }
        std::vector<FragmentPart> quarters, smaller;
        const auto mean_over = [&](std::vector<FragmentPart>& parts, int halvings, const JumpingFragment& jump) {
            if (parts.empty()) {
                parts = divide_pixel(view_, tile_, pixel, halvings);
            }
            return light_mean(parts, jump);
        };
        for (const JumpingFragment& jump : of_pixel) {
            if (jump.at_lamp || jump.step > kLargeJump || mean_over(quarters, kHalvings, jump) > kQuartersJump * seen) {
                mean_over(smaller, 2 * kHalvings, jump);
            }
        }
    }

  private:
    void light_stage(const SharingStage& stage, float tolerance, std::vector<PointLight>& all) {
        std::vector<std::uint32_t> pixels, indices;
        std::vector<KnownLight> known;
        own_.clear();
        for (const std::uint32_t p : stage.pixels) {
            for (std::uint32_t f = tile_.begin_of(p); f < tile_.pixels[p].end; ++f) {
                pixels.push_back(p);
                indices.push_back(f);
                own_.push_back(tile_.fragments[f]);
                known.push_back(shared_light(tile_, all, stage, p, f, tolerance));
                lit_.shared += known.back().soft ? 1 : 0;
            }
        }
        light_.assign(own_.size(), {});
        taken_.assign(own_.size(), {});
        for (std::size_t begin = 0; begin < own_.size(); begin += kFragmentsAtOnce) {
            control_.check_cancel();
            const std::size_t count = std::min(kFragmentsAtOnce, own_.size() - begin);
            gatherer_.shade(std::span(own_).subspan(begin, count), std::span(known).subspan(begin, count),
                            std::span(light_).subspan(begin, count), std::span(taken_).subspan(begin, count));
        }
        for (std::size_t i = 0; i < own_.size(); ++i) {
            all[indices[i]] = std::move(light_[i]);
            lit_.taken[pixels[i]].add(taken_[i]);
        }
    }

    // Over the parts of a fragment. Returns how much light differs between them, as the picture would show it if each
    // were the whole fragment.
    float light_mean(std::span<const FragmentPart> parts, const JumpingFragment& of) {
        own_.clear();
        for (const FragmentPart& part : parts) {
            if (part.fragment == of.fragment) {
                own_.push_back(part.at);
            }
        }
        light_.resize(own_.size());
        taken_.resize(own_.size());
        const std::uint32_t whole = tile_.begin_of(of.pixel) + of.fragment;
        gatherer_.shade_parts(tile_.fragments[whole], lit_.soft[whole], own_, light_, taken_);
        Rgb reflected(0.0F), albedo(0.0F), least(kInfinity), most(0.0F);
        for (std::size_t i = 0; i < own_.size(); ++i) {
            reflected += own_[i].albedo * light_[i].all;
            albedo += own_[i].albedo;
            least = glm::min(least, light_[i].all);
            most = glm::max(most, light_[i].all);
            lit_.taken[of.pixel].add(taken_[i]);
        }
        lit_.light[whole] = reflected / glm::max(albedo, Rgb(1e-20F));
        return luminance(albedo * (most - least));
    }

    const View& view_;
    const TileFragments& tile_;
    Gatherer& gatherer_;
    LitTile& lit_;
    const Control& control_;
    std::vector<Fragment> own_;
    std::vector<PointLight> light_;
    std::vector<PointCounts> taken_;
};

// Whether the pixel to the right or above shows another cell.
bool ends_a_cell(const PixelMap& map, std::size_t tile, std::uint32_t pixel, const Gatherer& gatherer) {
    const auto cell_in = [&](const TileFragments& in, std::uint32_t p) {
        const std::uint32_t first = in.begin_of(p);
        return first < in.pixels[p].end ? gatherer.cell_of(in.fragments[first]) : kNone;
    };
    const std::uint32_t own = cell_in(map.tiles()[tile], pixel);
    const PixelMap::Pixel* right = map.beside(tile, pixel, 1, 0);
    const PixelMap::Pixel* above = map.beside(tile, pixel, 0, 1);
    return (right != nullptr && cell_in(map.tiles()[right->tile], right->index) != own) ||
           (above != nullptr && cell_in(map.tiles()[above->tile], above->index) != own);
}

std::vector<PassValues> pass_values(const PixelMap& map, std::size_t tile, const LitTile& lit, PassSet passes,
                                    const MaskingMap* seen, const Gatherer& gatherer) {
    const TileFragments& own = map.tiles()[tile];
    std::vector<PassValues> values(passes.bits != 0 ? lit.taken.size() : 0);
    for (std::uint32_t p = 0; p < values.size(); ++p) {
        const PixelCounts& taken = lit.taken[p];
        const auto points = static_cast<float>(std::max(taken.points, 1U));
        values[p][Pass::kVisibilitySamples] = static_cast<float>(taken.sum.visibility_rays);
        values[p][Pass::kFormFactorSamples] = static_cast<float>(taken.sum.form_factors);
        values[p][Pass::kResampledSenders] = static_cast<float>(taken.sum.senders) / points;
        values[p][Pass::kSurfaceSites] = taken.sum.on_surface / points;
        if (passes.has(Pass::kCellLines)) {
            values[p][Pass::kCellLines] = ends_a_cell(map, tile, p, gatherer) ? 1.0F : 0.0F;
        }
        if (seen != nullptr) {
            const std::size_t x = own.tile.x + p % own.tile.width, y = own.tile.y + p / own.tile.width;
            values[p][Pass::kThresholdElevation] = seen->elevation[y * seen->width + x];
            values[p][Pass::kAdaptationLuminance] = seen->adaptation[y * seen->width + x];
        }
        if (passes.has(Pass::kSiteThreshold) && own.begin_of(p) < own.pixels[p].end) {
            values[p][Pass::kSiteThreshold] = gatherer.threshold_at(own.fragments[own.begin_of(p)]);
        }
    }
    return values;
}

}  // namespace

ViewCounts light_tiles(const View& view, std::span<const TileFragments> tiles, const MaskingMap* seen,
                       const Sharing& sharing, const std::function<std::unique_ptr<Gatherer>()>& make, Film& film,
                       Control& control, Statistics& statistics) {
    const StageTimer timer(statistics, "shading");
    std::mutex mutex;
    GatherCounts total;
    std::atomic<std::uint32_t> finished{0};
    const auto step = [&](const Gatherer& gatherer) {
        const std::scoped_lock lock(mutex);
        total += gatherer.counts();
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(2 * tiles.size()));
    };
    std::vector<LitTile> lit(tiles.size());
    parallel_for(tiles.size(), 1, control, [&](std::size_t i) {
        const auto gatherer = make();
        TileLighter(view, tiles[i], *gatherer, lit[i], control).light_fragments(sharing);
        step(*gatherer);
    });
    std::vector<TileLight> before;  // what jumps are found in while light changes
    before.reserve(lit.size());
    std::uint64_t shared = 0;
    for (const LitTile& tile : lit) {
        shared += tile.shared;
        before.push_back(tile.light);
    }
    std::atomic<std::uint64_t> dropped{0}, divided{0};
    const PixelMap map(tiles);
    parallel_for(tiles.size(), 1, control, [&](std::size_t i) {
        const auto gatherer = make();
        TileLighter lighter(view, tiles[i], *gatherer, lit[i], control);
        const std::vector<JumpingFragment> jumps = jumps_in(map, i, before, view.scene.lamps, view.camera);
        for (std::size_t begin = 0, end = 0; begin < jumps.size(); begin = end) {
            while (end < jumps.size() && jumps[end].pixel == jumps[begin].pixel) {
                ++end;
            }
            lighter.light_parts(std::span(jumps).subspan(begin, end - begin));
        }
        divided += jumps.size();
        std::vector<Rgba> pixels(tiles[i].pixels.size());
        dropped += resolve_tile(view, tiles[i], lit[i].light, pixels);
        film.finish_tile(static_cast<std::uint32_t>(i), pixels,
                         pass_values(map, i, lit[i], film.passes(), seen, *gatherer));
        step(*gatherer);
    });
    report(total, statistics);
    statistics.set_count("fragments divided", static_cast<double>(divided));
    statistics.set_count("fragments that share soft light", static_cast<double>(shared));
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

}  // namespace gg
