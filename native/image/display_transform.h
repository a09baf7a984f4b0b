// From scene-linear pixels to what a display shows, as Blender does it: curves, exposure, look, view, gamma.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/vec.h"
#include "image/view_curves.h"

namespace gg {

struct DisplaySettings {
    std::string config;  // path of an OpenColorIO configuration; empty: sRGB, with white at 1
    std::string device, view;
    std::string look;    // empty: none
    float exposure = 0;  // stops
    float gamma = 1;
    std::optional<ViewCurves> curves = std::nullopt;
};

class DisplayTransform {
  public:
    // Never fails: what cannot be had is replaced by sRGB, and failure() says why.
    explicit DisplayTransform(const DisplaySettings& settings);
    ~DisplayTransform();
    DisplayTransform(const DisplayTransform&) = delete;
    DisplayTransform& operator=(const DisplayTransform&) = delete;

    [[nodiscard]] const std::string& failure() const { return failure_; }

    // Values for the display's connector, 0..1. What is not finite counts as black. Any number of threads at once.
    void encode(std::span<Rgb> pixels) const;
    // Light that the display makes of them, linear, 0..1 of its white. All displays decode as sRGB.
    void show(std::span<Rgb> pixels) const;

  private:
    struct Processor;
    std::unique_ptr<const Processor> processor_;  // null: sRGB
    float scale_ = 1, exponent_ = 1;              // for sRGB
    std::optional<ViewCurves> curves_;
    std::string failure_;
};

}  // namespace gg
