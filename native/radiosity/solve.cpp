#include "radiosity/solve.h"

#include <algorithm>

#include "core/control.h"
#include "core/statistics.h"
#include "radiosity/creases.h"
#include "radiosity/interpolation.h"
#include "radiosity/large_faces.h"
#include "radiosity/mesh_balance.h"
#include "radiosity/refine.h"
#include "radiosity/separators.h"
#include "radiosity/shadow_edges.h"
#include "radiosity/solution_data.h"
#include "radiosity/source_guide.h"

namespace gg {

namespace {

// Multigridding: coarse links carry the light around once before finer ones are judged by it.
constexpr float kCoarseness[] = {16, 4, 1};
// Of what is asked for: links only have to guide, for faces look around in the end; edges of shadows are seen.
constexpr float kLinkError = 2, kEdgeError = 0.5F, kSeparatorError = 1.5F, kCreaseError = 2;
constexpr float kCoarsestCreases = 0.02F;  // quality: along the edges of rooms a coarser solve would be far off
constexpr float kLargeFace = 0.1F;         // share of the extent of light
constexpr int kSweepsBetween = 5;
constexpr int kSweepsAtEnd = 200;          // enough for a mean reflectance of 0.97
constexpr double kConverged = 2e-3;        // sum of all changes of reflected power in one step, share of it
constexpr double kNearlyConverged = 1e-2;  // change of the whole, before faces look around

struct Power {
    double emitted = 0, absorbed = 0;  // W, luminance
};

// In a closed room both are equal; what a scene emits and does not absorb leaves it.
Power power_balance(const Solution& solution) {
    Power power;
    for (NodeId id = 0; id < solution.hierarchy.nodes().size(); ++id) {
        const Node& node = solution.hierarchy[id];
        if (is_surface(node) && node.child_count == 0) {
            const Rgb irradiance = solution.lighting.irradiance(id);
            const double area = solution.lighting.area(id);
            power.absorbed += area * luminance((1.0F - node.reflectance) * irradiance);
            power.emitted += area * luminance(solution.lighting.radiosity(id) - node.reflectance * irradiance);
        }
    }
    for (const Link& link : solution.links.all) {
        if (solution.hierarchy[link.sender].kind == NodeKind::kLamp) {
            const bool element = solution.hierarchy[link.receiver].kind == NodeKind::kElement;
            power.emitted += (element ? 1.0 : 0.25) * solution.lighting.area(link.receiver) * link.form_factor *
                             link.visibility * luminance(solution.hierarchy[link.sender].emission);
        }
    }
    return power;
}

void report(const Solution& solution, Statistics& statistics) {
    std::size_t elements = 0, clusters = 0, open = 0;
    for (const Node& node : solution.hierarchy.nodes()) {
        elements += node.kind == NodeKind::kElement && node.child_count == 0;
        clusters += is_cluster(node) && node.child_count == 0;
        open += node.child_count > 0;
    }
    statistics.set_count("elements", static_cast<double>(elements));
    statistics.set_count("leaf clusters", static_cast<double>(clusters));
    statistics.set_count("opened nodes", static_cast<double>(open));
    std::size_t to_surface = 0, near = 0, lamps = 0, sky = 0, dark = 0;
    for (const Link& link : solution.links.all) {
        const NodeKind sender = solution.hierarchy[link.sender].kind;
        near += link.near;
        lamps += sender == NodeKind::kLamp;
        sky += sender == NodeKind::kSky;
        dark += !(link.visibility > 0);
        to_surface += solution.hierarchy[link.receiver].kind == NodeKind::kElement;
    }
    statistics.set_count("links", static_cast<double>(solution.links.all.size()));
    statistics.set_count("links to elements", static_cast<double>(to_surface));
    statistics.set_count("links of touching nodes", static_cast<double>(near));
    statistics.set_count("links from lamps", static_cast<double>(lamps));
    statistics.set_count("links from sky", static_cast<double>(sky));
    statistics.set_count("links occluded", static_cast<double>(dark));
    const Power power = power_balance(solution);
    statistics.set_count("power that lands or is emitted by surfaces", power.emitted);
    statistics.set_count("power absorbed", power.absorbed);
    statistics.set_count("reference white", solution.white.irradiance);
    statistics.set_count("extent of light", solution.white.extent);
    statistics.set_bytes("hierarchy", static_cast<double>(solution.hierarchy.bytes() + solution.lighting.bytes()));
    statistics.set_bytes("faces", static_cast<double>(solution.face_light.bytes()));
    statistics.set_bytes("links", static_cast<double>(solution.links.all.capacity() * sizeof(Link) +
                                                      solution.links.hits.capacity() * sizeof(NearHit)));
}

// Rays from a group of faces: 8 at the default quality.
int face_rays(float quality) {
    constexpr float kLeast = 4, kMost = 32;
    return static_cast<int>(std::clamp(0.16F / quality, kLeast, kMost));
}

// From now on links stand in the order of their receivers.
void sort_links(Solution& solution) {
    std::vector<Link>& links = solution.links.all;
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
        return a.receiver != b.receiver ? a.receiver < b.receiver : a.sender < b.sender;
    });
    solution.link_begin.assign(solution.hierarchy.nodes().size() + 1, 0);
    for (const Link& link : links) {
        ++solution.link_begin[link.receiver + 1];
    }
    for (std::size_t i = 1; i < solution.link_begin.size(); ++i) {
        solution.link_begin[i] += solution.link_begin[i - 1];
    }
}

// Leaves the solution to what faces see by rays of their own. Returns the number of iterations.
int look_around(Solution& solution, const SourceGuide& guide, std::span<const Rgb> emitted_by_links,
                const RayTracer& tracer, int rays, const Control& control) {
    if (!solution.hierarchy.has_geometry()) {
        return 0;
    }
    solution.elements = find_elements(solution.hierarchy);
    GatheredLight& light = solution.face_light;
    light = GatheredLight(solution.hierarchy, solution.elements, guide, solution.lighting, emitted_by_links, tracer,
                          rays, control);
    const int iterations = light.settle(kSweepsAtEnd, kConverged, control);
    light.tell(solution.lighting, control);
    light.finish();
    return iterations;
}

}  // namespace

std::shared_ptr<const Solution> solve(const Scene& scene, const SurfaceColors& colors, const RayTracer& tracer,
                                      const SolveSettings& settings, Control& control, Statistics& statistics) {
    std::shared_ptr<Solution> solution;
    {
        const StageTimer timer(statistics, "clusters");
        solution = std::make_shared<Solution>(scene, colors, make_scene_faces(scene, colors, tracer, control));
        solution->lighting.grow(control);
    }
    solution->links = initial_links(solution->hierarchy);
    int sweeps = 0;
    std::vector<Rgb> emitted_by_links;
    SourceGuide guide;
    for (const float coarseness : kCoarseness) {
        {
            const StageTimer timer(statistics, "refine");
            solution->white = reference_white(solution->hierarchy, solution->lighting);
            const RefineSettings refine_settings{kLinkError * settings.quality * coarseness, solution->white};
            refine(solution->hierarchy, solution->lighting, tracer, solution->links, refine_settings, control,
                   statistics);
            if (coarseness <= 1) {
                guide = SourceGuide(solution->hierarchy, solution->links.all);
                open_large_faces(solution->hierarchy, solution->lighting, kLargeFace * solution->white.extent, control);
                const RefineSettings edges{kEdgeError * settings.quality, solution->white};
                split_at_shadow_edges(solution->hierarchy, solution->lighting, guide, tracer, edges, control);
                split_at_separators(solution->hierarchy, solution->lighting, tracer,
                                    {kSeparatorError * settings.quality, solution->white}, control);
                split_at_creases(solution->hierarchy, solution->lighting, tracer,
                                 {kCreaseError * std::min(settings.quality, kCoarsestCreases), solution->white},
                                 control);
                balance_elements(solution->hierarchy, solution->lighting, control);
            }
        }
        const StageTimer timer(statistics, "gather");
        solution->lighting.set_links(solution->links, control);
        if (coarseness <= 1) {
            solution->lighting.clear(control);
            solution->lighting.iterate(control);
            emitted_by_links = solution->lighting.irradiances();
        }
        const int most = coarseness > 1 ? kSweepsBetween : kSweepsAtEnd;
        sweeps += solution->lighting.settle(most, kNearlyConverged, control);
    }
    {
        const StageTimer timer(statistics, "faces");
        sweeps += look_around(*solution, guide, emitted_by_links, tracer, face_rays(settings.quality), control);
        statistics.set_count("gain of links", solution->lighting.gain());
        statistics.set_count("face groups", static_cast<double>(solution->face_light.count()));
    }
    statistics.set_count("sweeps", sweeps);
    {
        const StageTimer timer(statistics, "interpolate");
        interpolate_to_vertices(*solution, control);
    }
    sort_links(*solution);
    solution->clusters = find_clusters(solution->hierarchy);
    report(*solution, statistics);
    return solution;
}

}  // namespace gg
