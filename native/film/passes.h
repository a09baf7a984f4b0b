// Passes that tell how a picture was made; all have one value a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gg {

// In the order of the bits of gg_settings::passes.
enum class Pass : std::uint8_t {
    kVisibilitySamples,
    kFormFactorSamples,
    kResampledSenders,
    kCellLines,
    kSurfaceSites,
    kThresholdElevation,
    kAdaptationLuminance,
    kSiteThreshold
};
inline constexpr std::uint32_t kPassCount = 8;
inline constexpr std::array<std::string_view, kPassCount> kPassNames{
    "Visibility Samples", "Form Factor Samples", "Resampled Senders",    "Cell Lines",
    "Surface Sites",      "Threshold Elevation", "Adaptation Luminance", "Site Threshold"};

// Which of them are wanted: a bit each.
struct PassSet {
    std::uint32_t bits = 0;

    [[nodiscard]] bool has(Pass pass) const { return (bits >> static_cast<unsigned>(pass) & 1U) != 0; }
};

// Of one pixel.
struct PassValues {
    std::array<float, kPassCount> of{};

    float& operator[](Pass pass) { return of[static_cast<std::size_t>(pass)]; }
    float operator[](Pass pass) const { return of[static_cast<std::size_t>(pass)]; }
};

}  // namespace gg
