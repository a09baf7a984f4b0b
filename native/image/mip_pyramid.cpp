#include "image/mip_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gg {

namespace {

struct Grid {
    std::uint32_t width = 0, height = 0;
    std::vector<Rgb> texels;
};

std::vector<MipLevel> make_levels(std::uint32_t width, std::uint32_t height) {
    std::vector<MipLevel> levels = {{width, height, 0}};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const MipLevel& last = levels.back();
        levels.push_back({std::max(last.width / 2, 1U), std::max(last.height / 2, 1U),
                          last.offset + 3 * std::size_t{last.width} * last.height});
    }
    return levels;
}

// Texels of the finer row that one texel of the coarser covers, with their shares. Sizes that are not even give parts
// of texels: 5 to 2 is (1, 1, 1/2) and (1/2, 1, 1), each over 5/2. No ratio is over 3, so no more than 4 take part.
struct Cover {
    std::uint32_t first = 0, count = 0;
    std::array<float, 4> shares{};
};

std::vector<Cover> make_covers(std::uint32_t fine, std::uint32_t coarse) {
    std::vector<Cover> covers(coarse);
    for (std::uint64_t index = 0; index < coarse; ++index) {
        // In units of 1 / coarse of a fine texel, so that all is exact.
        const std::uint64_t begin = index * fine;
        const std::uint64_t end = begin + fine;
        Cover& cover = covers[index];
        cover.first = static_cast<std::uint32_t>(begin / coarse);
        for (std::uint64_t texel = cover.first; texel * coarse < end; ++texel) {
            const std::uint64_t shared = std::min(end, (texel + 1) * coarse) - std::max(begin, texel * coarse);
            cover.shares[cover.count++] = static_cast<float>(shared) / static_cast<float>(fine);
        }
    }
    return covers;
}

// texel(x, y) -> Rgb of the finer level.
template <typename Texel>
Grid downsample(const MipLevel& fine, const MipLevel& coarse, const Texel& texel) {
    const std::vector<Cover> columns = make_covers(fine.width, coarse.width);
    const std::vector<Cover> rows = make_covers(fine.height, coarse.height);
    Grid result{coarse.width, coarse.height, {}};
    result.texels.reserve(std::size_t{coarse.width} * coarse.height);
    for (const Cover& row : rows) {
        for (const Cover& column : columns) {
            Rgb sum(0);
            for (std::uint32_t j = 0; j < row.count; ++j) {
                Rgb line(0);
                for (std::uint32_t i = 0; i < column.count; ++i) {
                    line += column.shares[i] * texel(column.first + i, row.first + j);
                }
                sum += row.shares[j] * line;
            }
            result.texels.push_back(sum);
        }
    }
    return result;
}

void store_level(const Grid& grid, const MipLevel& level, bool srgb, MipPyramid& pyramid) {
    std::size_t at = level.offset;
    for (const Rgb& color : grid.texels) {
        for (int channel = 0; channel < 3; ++channel, ++at) {
            if (pyramid.decoding != nullptr) {
                pyramid.bytes[at] = encode_byte(color[channel], srgb);
            } else {
                pyramid.halves[at] = float_to_half(color[channel]);
            }
        }
    }
}

void store_finest(RawImage&& image, bool srgb, std::size_t values, MipPyramid& pyramid) {
    if (image.header.bytes) {
        pyramid.decoding = byte_decoding(srgb);
        pyramid.bytes = std::move(image.bytes);
        pyramid.bytes.resize(values);
        return;
    }
    pyramid.halves.resize(values);
    std::transform(image.floats.begin(), image.floats.end(), pyramid.halves.begin(), [srgb](float value) {
        return std::isfinite(value) ? float_to_half(srgb ? srgb_to_linear(value) : value) : std::uint16_t{0};
    });
    std::vector<float>().swap(image.floats);
}

template <typename T>
void erase_front(std::vector<T>& values, std::size_t count) {
    if (!values.empty()) {
        values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
        values.shrink_to_fit();
    }
}

void drop_finest(MipPyramid& pyramid, std::uint32_t dropped) {
    const std::size_t count = std::min<std::size_t>(dropped, pyramid.levels.size() - 1);
    const std::size_t offset = pyramid.levels[count].offset;
    erase_front(pyramid.levels, count);
    erase_front(pyramid.bytes, offset);
    erase_front(pyramid.halves, offset);
    for (MipLevel& level : pyramid.levels) {
        level.offset -= offset;
    }
}

}  // namespace

MipPyramid make_mip_pyramid(RawImage&& image, bool srgb, std::uint32_t dropped) {
    MipPyramid pyramid;
    pyramid.levels = make_levels(image.header.width, image.header.height);
    store_finest(std::move(image), srgb, pyramid.levels.back().offset + 3, pyramid);
    // Coarser levels come from floats, not from the stored level before: rounding must not add up.
    Grid grid;
    for (std::size_t index = 1; index < pyramid.levels.size(); ++index) {
        const MipLevel& fine = pyramid.levels[index - 1];
        const MipLevel& coarse = pyramid.levels[index];
        if (index == 1) {
            grid = downsample(fine, coarse, [&](auto x, auto y) { return pyramid.texel(fine, x, y); });
        } else {
            grid =
                downsample(fine, coarse, [&](auto x, auto y) { return grid.texels[std::size_t{y} * grid.width + x]; });
        }
        store_level(grid, coarse, srgb, pyramid);
    }
    if (dropped > 0) {
        drop_finest(pyramid, dropped);
    }
    return pyramid;
}

std::size_t pyramid_bytes(const ImageHeader& header, std::uint32_t dropped) {
    const std::vector<MipLevel> levels = make_levels(header.width, header.height);
    const std::size_t first = std::min<std::size_t>(dropped, levels.size() - 1);
    return (levels.back().offset + 3 - levels[first].offset) * (header.bytes ? 1 : 2);
}

}  // namespace gg
