// Small scenes for tests, built as descriptions.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/control.h"
#include "core/messages.h"
#include "core/statistics.h"
#include "image/texture.h"
#include "material/surface_color.h"
#include "radiosity/solution_data.h"
#include "radiosity/solve.h"
#include "scene/build_scene.h"
#include "scene/load_textures.h"
#include "trace/ray_tracer.h"

namespace gg::test {

// Grows a description, one object at a time.
class SceneBuilder {
  public:
    SceneDescription description;

    // emitted_radiance in W/(m2 sr)
    std::uint32_t material(Rgb reflectance, Rgb emitted_radiance = Rgb(0.0F));
    // Reflectance of a checkerboard of 8 x 8 fields of these two greys over the unit square of uv.
    std::uint32_t checkerboard(float dark, float bright);
    // A quadrilateral of two triangles; front is where a, b, c, d run counterclockwise.
    // uvs are (0, 0), (1, 0), (1, 1), (0, 1).
    void quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d, std::uint32_t material, const std::string& name = "quad");
    // Six separate quads, -x, +x, -y, +y, -z, +z; inward: their fronts face the inside.
    void box(Vec3 lower, Vec3 upper, const std::array<std::uint32_t, 6>& materials, bool inward);
    // A closed cube as one mesh, outward.
    void solid(Vec3 lower, Vec3 upper, std::uint32_t material, const std::string& name = "solid");
    // Latitude-longitude sphere, outward or inward winding, smooth.
    void sphere(Vec3 center, float radius, int rings, std::uint32_t material, bool inward,
                const std::string& name = "sphere");
    void area_light(Vec3 position, Vec3 direction, float size, Rgb watts, const std::string& name = "area");
    void sun(Vec3 direction, Rgb irradiance, const std::string& name = "sun");
    void point_light(Vec3 position, Rgb watts, const std::string& name = "point");
    void add_mesh(MeshDescription mesh, std::uint32_t material);
};

// A scene with everything that the solve needs, kept alive together.
struct Prepared {
    explicit Prepared(SceneDescription input);

    SceneDescription description;
    Messages messages;
    Control control;
    Statistics statistics;
    Scene scene;
    std::unique_ptr<TextureSet> textures;
    std::unique_ptr<SurfaceColors> colors;
    std::unique_ptr<RayTracer> tracer;

    std::shared_ptr<const Solution> solve(float quality = 0.02F);
    [[nodiscard]] SceneFaces faces() const;
    // Of a hierarchy of this scene.
    [[nodiscard]] Link estimate(const Hierarchy& hierarchy, NodeId receiver, NodeId sender, int rays) const;
};

}  // namespace gg::test
