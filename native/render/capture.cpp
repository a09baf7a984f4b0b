#include "render/capture.h"

#include <concepts>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/error.h"

namespace gg {

namespace {

constexpr std::string_view kMagic = "gridgather capture 1\n";  // the number changes with any of the fields below

// What is written as it lies in memory.
template <typename T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_bounded_array_v<T> || std::same_as<T, Vec2> ||
    std::same_as<T, Vec3> || std::same_as<T, Affine>;

template <typename T, typename Struct>
concept Is = std::same_as<std::remove_const_t<T>, Struct>;

// The fields of every struct, for both directions.
template <typename A>
void fields(A& archive, Is<ImageDescription> auto& v) {
    archive(v.name, v.path, v.pixels, v.width, v.height, v.color_space, v.extension, v.filter_mode);
}
template <typename A>
void fields(A& archive, Is<ColorInput> auto& v) {
    archive(v.factor, v.image, v.uv_map);
}
template <typename A>
void fields(A& archive, Is<MaterialDescription> auto& v) {
    archive(v.name, v.reflectance, v.emission);
}
template <typename A>
void fields(A& archive, Is<MeshDescription> auto& v) {
    archive(v.name, v.positions, v.triangle_vertices, v.triangle_corners, v.triangle_slots, v.corner_normals,
            v.corner_uvs);
}
template <typename A>
void fields(A& archive, Is<InstanceDescription> auto& v) {
    archive(v.name, v.mesh, v.materials, v.flags, v.stable_id, v.to_world);
}
template <typename A>
void fields(A& archive, Is<LightDescription> auto& v) {
    archive(v.name, v.type, v.to_world, v.power, v.radius, v.soft_falloff, v.size_x, v.size_y, v.shape, v.spot_angle,
            v.spot_blend, v.angle, v.stable_id);
}
template <typename A>
void fields(A& archive, Is<SceneDescription> auto& v) {
    archive(v.images, v.materials, v.material_lists, v.meshes, v.instances, v.lights, v.world);
}
template <typename A>
void fields(A& archive, Is<CameraDescription> auto& v) {
    archive(v.type, v.to_world, v.window, v.clip_start, v.clip_end);
}
template <typename A>
void fields(A& archive, Is<ViewSettings> auto& v) {
    archive(v.crop.x, v.crop.y, v.crop.width, v.crop.height, v.samples, v.exposure, v.film_transparent);
}
template <typename A>
void fields(A& archive, Is<GatherSettings> auto& v) {
    archive(v.free_space, v.surfaces, v.shared, v.law, v.cell, v.threshold, v.samples);
}
template <typename A>
void fields(A& archive, Is<ViewCurves> auto& v) {
    for (auto& channel : v.channels) {
        archive(channel.values, channel.slope_below, channel.slope_above, channel.black, channel.white);
    }
    archive(v.lower, v.upper);
}
template <typename A>
void fields(A& archive, Is<DisplaySettings> auto& v) {
    archive(v.config, v.device, v.view, v.look, v.exposure, v.gamma, v.curves);
}
template <typename A>
void fields(A& archive, Is<Viewing> auto& v) {
    archive(v.white, v.black, v.pixels_per_degree);
}
template <typename A>
void fields(A& archive, Is<RenderSettings> auto& v) {
    archive(v.method, v.camera, v.width, v.height, v.view, v.filter_type, v.filter_width, v.quality, v.threads,
            v.passes.bits, v.gather, v.display, v.viewing, v.noticeable, v.masking);
}

class Writer {
  public:
    explicit Writer(std::ofstream& out) : out_(out) {}

    template <typename... T>
    void operator()(const T&... values) {
        (put(values), ...);
    }

  private:
    void put_bytes(const void* bytes, std::size_t count) {
        out_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    }
    template <typename T>
    void put(const T& value) {
        if constexpr (Plain<T>) {
            put_bytes(&value, sizeof(T));
        } else {
            fields(*this, value);
        }
    }
    void put(const std::string& text) {
        put(std::uint64_t{text.size()});
        put_bytes(text.data(), text.size());
    }
    template <typename T>
    void put(const std::vector<T>& values) {
        put(std::uint64_t{values.size()});
        if constexpr (Plain<T>) {
            put_bytes(values.data(), values.size() * sizeof(T));
        } else {
            for (const T& value : values) {
                put(value);
            }
        }
    }
    template <typename T>
    void put(const std::optional<T>& value) {
        put(value.has_value());
        if (value) {
            put(*value);
        }
    }

    std::ofstream& out_;
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] bool at_end() const { return rest_.empty(); }
    template <typename... T>
    void operator()(T&... values) {
        (get(values), ...);
    }

  private:
    std::string_view take(std::size_t count) {
        if (count > rest_.size()) {
            throw Error(GG_IO_ERROR, "the capture is cut off or damaged");
        }
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    // Of items that take at least so many bytes each.
    std::size_t get_count(std::size_t bytes) {
        std::uint64_t count = 0;
        get(count);
        if (count > rest_.size() / bytes) {
            throw Error(GG_IO_ERROR, "the capture is cut off or damaged");
        }
        return count;
    }
    void get(bool& value) { value = take(1)[0] != 0; }
    template <typename T>
    void get(T& value) {
        if constexpr (Plain<T>) {
            std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
        } else {
            fields(*this, value);
        }
    }
    void get(std::string& text) { text = take(get_count(1)); }
    template <typename T>
    void get(std::vector<T>& values) {
        if constexpr (Plain<T>) {
            values.resize(get_count(sizeof(T)));
            const std::string_view bytes = take(values.size() * sizeof(T));
            std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
        } else {
            values.resize(get_count(1));
            for (T& value : values) {
                get(value);
            }
        }
    }
    template <typename T>
    void get(std::optional<T>& value) {
        bool any = false;
        get(any);
        value.reset();
        if (any) {
            get(value.emplace());
        }
    }

    std::string_view rest_;
};

}  // namespace

void write_capture(const SceneDescription& scene, const RenderSettings& settings, const std::string& path) {
    const std::string unfinished = path + ".unfinished";
    {
        std::ofstream out(unfinished, std::ios::binary | std::ios::trunc);
        out << kMagic;
        Writer writer(out);
        writer(scene, settings);
        out.close();
        if (!out) {
            std::error_code ignored;
            std::filesystem::remove(unfinished, ignored);
            throw Error(GG_IO_ERROR, "cannot write " + path);
        }
    }
    std::error_code failure;
    std::filesystem::rename(unfinished, path, failure);
    if (failure) {
        std::filesystem::remove(unfinished, failure);
        throw Error(GG_IO_ERROR, "cannot write " + path);
    }
}

Capture read_capture(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in && bytes.empty()) {
        throw Error(GG_IO_ERROR, "cannot read " + path);
    }
    if (!bytes.starts_with(kMagic)) {
        throw Error(GG_IO_ERROR, path + " is not a capture of this version");
    }
    Capture capture;
    Reader reader(std::string_view(bytes).substr(kMagic.size()));
    reader(capture.scene, capture.settings);
    if (!reader.at_end()) {
        throw Error(GG_IO_ERROR, "the capture is cut off or damaged");
    }
    return capture;
}

}  // namespace gg
