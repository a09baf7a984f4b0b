// Image files for tests, written byte by byte in the simplest formats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/vec.h"

namespace gg::test {

// A name in the temporary folder that no other test has; the file is removed at the end.
class TempFile {
  public:
    explicit TempFile(const std::string& extension);
    ~TempFile();
    TempFile(const TempFile&) = delete;
    TempFile& operator=(const TempFile&) = delete;

    void write(const std::string& content) const;
    [[nodiscard]] std::string path() const { return path_.string(); }

  private:
    std::filesystem::path path_;
};

// Binary portable pixmap; values from the top row to the bottom one, 1 (grey) or 3 channels, most 255 or 65535.
[[nodiscard]] std::string pixmap(int width, int height, int channels, int most, const std::vector<int>& values);

// Radiance picture with floats, top row first. Components must be powers of two times up to 8 bits.
[[nodiscard]] std::string radiance_picture(int width, int height, const std::vector<Rgb>& values);

}  // namespace gg::test
