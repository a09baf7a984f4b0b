#include "gather/site_thresholds.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "film/radiosity_view.h"
#include "gather/receiver.h"
#include "perception/tvi.h"

namespace gg {

namespace {

constexpr std::size_t kPixelsAtOnce = 4096;
constexpr int kSteps = 12;       // of bisection over the range below
constexpr float kLeast = 1e-3F;  // error as a share of a site's brightness
constexpr float kMost = 4;
constexpr float kDarkest = 0.01F;  // share of the mean brightness below which sites tolerate no less

// Luminance of the display for scene-linear pixels, cd/m2.
std::vector<float> shown(const Observer& observer, std::vector<Rgb> pixels, const Control& control) {
    std::vector<float> luminances(pixels.size());
    parallel_blocks(pixels.size(), kPixelsAtOnce, control, [&](std::size_t begin, std::size_t end) {
        observer.display(std::span(pixels).subspan(begin, end - begin));
        for (std::size_t i = begin; i < end; ++i) {
            luminances[i] = observer.viewing.white * luminance(pixels[i]) + observer.viewing.black;
        }
    });
    return luminances;
}

}  // namespace

MaskingMap observe(const Observer& observer, const Solution& solution, const View& view,
                   std::span<const TileFragments> tiles, const Control& control) {
    const auto irradiance_of = [&](const Fragment& at) { return irradiance_at(solution, at); };
    MaskingMap map = masking_map(view.settings.crop.width, view.settings.crop.height,
                                 shown(observer, radiosity_view(view, tiles, irradiance_of, control), control),
                                 observer.viewing, control);
    if (!observer.masking) {
        std::fill(map.elevation.begin(), map.elevation.end(), 1.0F);
    }
    return map;
}

std::vector<float> noticeable_radiosity(const Observer& observer, std::span<const SiteView> sites, float exposure,
                                        const Control& control) {
    std::vector<Rgb> colors;
    std::vector<float> visible, brightness;
    double mean = 0;
    for (const SiteView& site : sites) {
        colors.push_back(exposure * site.radiance);
        visible.push_back(observer.noticeable * just_noticeable(site.adaptation) * site.elevation);
        brightness.push_back(luminance(colors.back()));
        mean += static_cast<double>(brightness.back()) / static_cast<double>(sites.size());
    }
    for (float& of_site : brightness) {
        of_site = std::max(of_site, kDarkest * static_cast<float>(mean));
    }
    const std::vector<float> as_it_is = shown(observer, colors, control);
    std::vector<float> low(sites.size(), kLeast), high(sites.size(), kMost), middle(sites.size());
    const auto with_error = [&](float sign) {
        std::vector<Rgb> wrong = colors;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            wrong[i] = glm::max(Rgb(0.0F), wrong[i] + sign * middle[i] * Rgb(brightness[i]));
        }
        return shown(observer, std::move(wrong), control);
    };
    for (int step = 0; step < kSteps; ++step) {
        for (std::size_t i = 0; i < sites.size(); ++i) {
            middle[i] = std::sqrt(low[i] * high[i]);
        }
        const std::vector<float> more = with_error(1), less = with_error(-1);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const float change = std::max(std::abs(more[i] - as_it_is[i]), std::abs(less[i] - as_it_is[i]));
            (change > visible[i] ? high : low)[i] = middle[i];
        }
    }
    std::vector<float> radiosity;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        radiosity.push_back(kPi * low[i] * brightness[i] / std::max(exposure, 1e-20F));
    }
    return radiosity;
}

}  // namespace gg
