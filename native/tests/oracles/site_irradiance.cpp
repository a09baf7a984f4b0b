#include "oracles/site_irradiance.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "gather/sender_light.h"
#include "trace/surface_point.h"

namespace gg::oracle {

namespace {

double luminance_of(Vec3d color) {
    return static_cast<double>(luminance(Rgb(color)));
}

class Evaluation {
  public:
    Evaluation(const ShadedScene& scene, const PlacedFragment& placed, std::vector<SiteRay>* rays)
        : scene_(scene),
          hierarchy_(hierarchy_of(scene.solution)),
          placed_(placed),
          x_(offset_origin(placed.at.position, placed.at.normal, 1)),
          n_(placed.at.shading_normal),
          rays_(rays) {}

    [[nodiscard]] Vec3d light() {
        Vec3d sum(0.0);
        for (const WeightedSite& weighted : placed_.sites()) {
            weight_ = static_cast<double>(weighted.weight);
            const Site& site = *weighted.site;
            sum += weight_ * (of_senders(site) + of_beams(site) + of_sky(site) + of_surroundings(site));
        }
        return sum;
    }

  private:
    void record(const SiteRay& ray) {
        if (rays_ != nullptr) {
            rays_->push_back(ray);
        }
    }

    [[nodiscard]] bool is_seen(Vec3 direction, bool infinite) const {
        return !scene_.tracer.occluded({x_, direction, 0, infinite ? kInfinity : 0.9999F}, RayMask::kLight);
    }

    // What the sites know of one sender together.
    struct Blended {
        float samples = 0;   // of its visibility; at least one, at most what a sender has
        float expected = 0;  // visibility
    };

    [[nodiscard]] Blended blended(NodeId sender) const {
        Blended sum;
        float weight = 0;
        for (const WeightedSite& weighted : placed_.sites()) {
            for (const SiteSender& model : weighted.site->senders) {
                if (model.sender == sender && model.resample_visibility) {
                    sum.samples += weighted.weight * model.samples;
                    sum.expected += weighted.weight * model.visibility;
                    weight += weighted.weight;
                }
            }
        }
        const float most = is_cluster(hierarchy_[sender]) ? kClusterPoints : 1024;
        return {std::clamp(sum.samples * std::pow(placed_.at.share, 0.75F), 1.0F, most), sum.expected / weight};
    }

    // By the same formula to the last digit: a ray that passes an edge otherwise now and then meets something else.
    [[nodiscard]] SenderPoint point_of(NodeId sender, std::uint32_t index) const {
        SenderGroup alone(scene_.solution, scene_.points);
        GroupPoint seen;
        alone.begin(sender);
        alone.add(x_, n_);
        alone.see(index, seen);
        return {seen.direction(0), alone.infinite(), seen.weight[0]};
    }

    [[nodiscard]] float disk_of(NodeId cluster) const { return 0.5F * hierarchy_[cluster].area / kClusterPoints; }

    [[nodiscard]] Vec3d form_factor(NodeId sender) const {
        if (!is_cluster(hierarchy_[sender])) {
            return Vec3d(unoccluded_irradiance(scene_.solution, sender, x_, n_));
        }
        Vec3d sum(0.0);
        for (std::uint32_t i = 0; i < kClusterPoints; ++i) {
            const FacePoint point = scene_.points.of(sender)[i];
            sum += Vec3d(irradiance_from(point, 1, point.position - x_, n_, disk_of(sender)));
        }
        return sum;
    }

    // Of a point that faces the receiver.
    [[nodiscard]] double facing_weight(NodeId sender) const {
        if (!is_cluster(hierarchy_[sender])) {
            return static_cast<double>(SenderSampler(scene_.solution, sender, x_, n_).facing_weight());
        }
        const ClusterFaces& points = scene_.points.of(sender);
        const Node& node = hierarchy_[sender];
        const float square = length_squared(node.center - x_) + node.radius * node.radius;
        return points.empty() ? 0 : static_cast<double>(luminance(points[0].power) / square);
    }

    // 0..1. light: of all of the sender.
    [[nodiscard]] double visibility(NodeId sender, double light) {
        const Blended sites = blended(sender);
        const double whole = std::floor(sites.samples), fraction = static_cast<double>(sites.samples) - whole;
        const auto count = static_cast<std::uint32_t>(std::ceil(sites.samples));
        // What the sites expect counts as much as a ten thousandth of a sample.
        double sent = 1e-4 * facing_weight(sender), seen = static_cast<double>(sites.expected) * sent;
        const std::size_t first = rays_ != nullptr ? rays_->size() : 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const SenderPoint to = point_of(sender, i);
            if (!(to.weight > 0)) {
                continue;
            }
            // In the mean over the first `whole` samples, and in that with the next one.
            const double of_whole = i < whole ? (1 - fraction) / whole : 0, of_more = fraction / (whole + 1);
            const double weight = (of_whole + of_more) * static_cast<double>(to.weight);
            sent += weight;
            if (!(dot(to.direction, placed_.at.normal) > 0)) {
                continue;  // its own surface is in the way
            }
            const bool visible = is_seen(to.direction, to.infinite);
            seen += visible ? weight : 0;
            record({RayKind::kSender, sender, i, visible ? kNone : 0, weight_ * light * weight});
        }
        for (std::size_t i = first; rays_ != nullptr && i < rays_->size(); ++i) {
            (*rays_)[i].light /= sent;
        }
        return sent > 0 ? seen / sent : 0;
    }

    [[nodiscard]] Vec3d of_senders(const Site& site) {
        Vec3d sum(0.0);
        for (const SiteSender& model : site.senders) {
            const double cosine = std::max(0.0F, dot(n_, model.direction));
            const Vec3d unoccluded =
                model.resample_form_factor ? form_factor(model.sender) : cosine * Vec3d(model.irradiance);
            const double visible = model.resample_visibility ? visibility(model.sender, luminance_of(unoccluded))
                                                             : static_cast<double>(model.visibility);
            sum += visible * unoccluded;
        }
        return sum;
    }

    [[nodiscard]] Vec3d of_beams(const Site& site) const {
        Vec3d sum(0.0);
        for (const Beam& beam : site.beams) {
            sum += std::max(0.0, static_cast<double>(dot(n_, beam.direction))) * Vec3d(beam.irradiance);
        }
        return sum;
    }

    [[nodiscard]] Vec3d of_sky(const Site& site) {
        const Vec3d world(hierarchy_.scene().world);
        Vec3d sum(0.0);
        for (const SkyLeaf& leaf : site.leaves) {
            const float cosine = dot(leaf.direction, n_);
            if (cosine > 0 && dot(leaf.direction, placed_.at.normal) > 0) {
                const Vec3d light = static_cast<double>(cosine * leaf.solid_angle) * world;
                const bool visible = is_seen(leaf.direction, true);
                sum += visible ? light : Vec3d(0.0);
                record({RayKind::kSky, leaf.id, 0, visible ? kNone : 0, weight_ * luminance_of(light)});
            }
        }
        return sum;
    }

    // The surface lies in or below one of the site's senders.
    [[nodiscard]] bool is_apart(const Site& site, NodeId place) const {
        for (NodeId node = place; node != kNone; node = hierarchy_[node].parent) {
            for (const SiteSender& model : site.senders) {
                if (model.sender == node) {
                    return true;
                }
            }
        }
        return false;
    }

    // Every direction of the table: what the site says of it, and as far as something is near, that instead. Where
    // little is seen of a fragment, one of two neighbours says what is near in both.
    [[nodiscard]] Vec3d of_surroundings(const Site& site) {
        const TableCosines cosines(n_);
        const bool in_pairs = placed_.at.share < 0.3F;
        Vec3d sum(0.0);
        for (std::uint32_t cell = 0; cell < kTableCells; ++cell) {
            const double cosine = cosines.of[cell];
            const Vec3d far = cosine * Vec3d(site.table.at(cell));
            const SkyCell place = table_cell(cell);
            const bool by_the_other = in_pairs && (place.i + place.j) % 2 != 0;
            std::vector<Vec3> directions{near_direction(by_the_other ? cell ^ 1U : cell)};
            if (site.close_cells[cell] && !in_pairs) {
                const auto four = close_directions(cell);
                directions.assign(four.begin(), four.end());
            }
            const bool close = directions.size() > 1;
            const double share = 1 / static_cast<double>(directions.size());
            for (std::uint32_t k = 0; k < directions.size(); ++k) {
                const bool sent = site.near_cells[cell] && dot(directions[k], placed_.at.normal) > 0;
                const std::uint32_t id = close ? kTableCells + 4 * cell + k : cell;
                sum += sent ? of_near_ray(site, id, directions[k], share * cosine, share * far) : share * far;
            }
        }
        return sum;
    }

    // far: what the site says.
    [[nodiscard]] Vec3d of_near_ray(const Site& site, std::uint32_t id, Vec3 direction, double cosine, Vec3d far) {
        const Hit hit = scene_.tracer.closest_hit({x_, direction, 0, kInfinity}, RayMask::kLight);
        SiteRay ray{RayKind::kNear, id, 0, kNone, 0};
        Vec3d light = far;
        if (!hit.missed()) {
            const double nearness = static_cast<double>(site.reach.nearness(hit.distance));
            const Vec3 front = world_area_vector(hierarchy_.scene(), hit.instance, hit.triangle);
            const LitPlace lit = lit_place(scene_.solution, hit, dot(front, direction) > 0);
            const Vec3d radiance(is_apart(site, lit.place) ? Rgb(0.0F) : lit.radiosity / kPi);
            light += nearness * (cosine * static_cast<double>(kTableSolidAngle) * radiance - far);
            ray.met = static_cast<std::uint32_t>(hash64(hash64(hit.instance, hit.triangle), lit.place) >> 33);
            ray.light = weight_ * (luminance_of(light) - luminance_of(far));
        }
        record(ray);
        return light;
    }

    const ShadedScene& scene_;
    const Hierarchy& hierarchy_;
    const PlacedFragment& placed_;
    Vec3 x_, n_;
    std::vector<SiteRay>* rays_;
    double weight_ = 0;  // of the site of the moment
};

}  // namespace

Vec3d site_irradiance(const ShadedScene& scene, const PlacedFragment& placed, std::vector<SiteRay>* rays) {
    return Evaluation(scene, placed, rays).light();
}

}  // namespace gg::oracle
