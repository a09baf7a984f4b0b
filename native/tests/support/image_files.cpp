#include "support/image_files.h"

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <fstream>

namespace gg::test {

TempFile::TempFile(const std::string& extension) {
    static std::atomic<int> count{0};
    path_ = std::filesystem::temp_directory_path() /
            ("gridgather_test_" + std::to_string(getpid()) + "_" + std::to_string(++count) + extension);
}

TempFile::~TempFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void TempFile::write(const std::string& content) const {
    std::ofstream(path_, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
}

std::string pixmap(int width, int height, int channels, int most, const std::vector<int>& values) {
    std::string content = (channels == 1 ? "P5\n" : "P6\n") + std::to_string(width) + " " + std::to_string(height) +
                          "\n" + std::to_string(most) + "\n";
    for (const int value : values) {
        if (most > 255) {
            content.push_back(static_cast<char>(value >> 8));
        }
        content.push_back(static_cast<char>(value & 255));
    }
    return content;
}

std::string radiance_picture(int width, int height, const std::vector<Rgb>& values) {
    std::string content =
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
    for (const Rgb& value : values) {
        int exponent = 0;
        std::frexp(max_component(value), &exponent);
        for (int channel = 0; channel < 3; ++channel) {
            content.push_back(static_cast<char>(static_cast<int>(std::ldexp(value[channel], 8 - exponent))));
        }
        content.push_back(static_cast<char>(exponent + 128));
    }
    return content;
}

}  // namespace gg::test
