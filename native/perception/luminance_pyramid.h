// A picture at half, a quarter, ... of its resolution [Burt and Adelson 1983].
#pragma once

#include <cstdint>
#include <vector>

namespace gg {

class Control;

class LuminancePyramid {
  public:
    // values: row by row, width * height. levels: >= 1, with the picture itself. Throws Cancelled.
    LuminancePyramid(std::uint32_t width, std::uint32_t height, std::vector<float> values, int levels,
                     const Control& control);

    [[nodiscard]] int level_count() const { return static_cast<int>(levels_.size()); }

    // One row of a level, stretched to the picture's own size: linear between the level's samples, the first of which
    // lies on the picture's first. row: of the picture. values: of its width.
    void stretched_row(int level, std::uint32_t row, std::vector<float>& values) const;

  private:
    struct Level {
        std::uint32_t width = 0, height = 0;
        std::vector<float> values;
    };

    [[nodiscard]] static Level halved(const Level& level, const Control& control);

    std::vector<Level> levels_;
};

}  // namespace gg
