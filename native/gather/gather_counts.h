// What the gather did, for statistics.
#pragma once

#include <cstdint>

namespace gg {

struct GatherCounts {
    std::uint64_t points = 0;           // gathered at, or sites classified
    std::uint64_t senders = 0;          // looked at there
    std::uint64_t form_factors = 0;     // worked out at points
    std::uint64_t visibility_rays = 0;  // to senders
    std::uint64_t near_rays = 0;        // in fixed directions
    double visibility_seconds = 0;      // that rays to senders and the sky took, of all threads
    double on_surface = 0;              // sum over points of the weight of sites on their own surface
    // Senders of sites that are resampled: both terms, or one alone.
    std::uint64_t both = 0, only_visibility = 0, only_form_factor = 0;

    GatherCounts& operator+=(const GatherCounts& other) {
        points += other.points;
        senders += other.senders;
        form_factors += other.form_factors;
        visibility_rays += other.visibility_rays;
        near_rays += other.near_rays;
        visibility_seconds += other.visibility_seconds;
        on_surface += other.on_surface;
        both += other.both;
        only_visibility += other.only_visibility;
        only_form_factor += other.only_form_factor;
        return *this;
    }
};

// What one point took.
struct PointCounts {
    std::uint32_t visibility_rays = 0;  // to senders, the sky and what is near
    std::uint32_t form_factors = 0, senders = 0;
    float on_surface = 0;  // 0..1: weight of its sites that stand on its own surface
};

}  // namespace gg
