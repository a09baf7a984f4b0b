// The one switch between Embree 3 and 4, which differ in how a query's flags are passed.
#pragma once

#if GG_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace gg {

#if GG_EMBREE_MAJOR >= 4

struct EmbreeQuery {
    explicit EmbreeQuery(bool coherent) {
        rtcInitIntersectArguments(&intersect);
        rtcInitOccludedArguments(&occluded);
        intersect.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
        occluded.flags = intersect.flags;
    }
    RTCIntersectArguments intersect;
    RTCOccludedArguments occluded;
};

inline void closest(RTCScene scene, EmbreeQuery& query, RTCRayHit& ray) {
    rtcIntersect1(scene, &ray, &query.intersect);
}
inline void closest(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRayHit8& rays) {
    rtcIntersect8(valid, scene, &rays, &query.intersect);
}
inline void any(RTCScene scene, EmbreeQuery& query, RTCRay& ray) {
    rtcOccluded1(scene, &ray, &query.occluded);
}
inline void any(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &rays, &query.occluded);
}

#else

struct EmbreeQuery {
    explicit EmbreeQuery(bool coherent) {
        rtcInitIntersectContext(&context);
        context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    RTCIntersectContext context;
};

inline void closest(RTCScene scene, EmbreeQuery& query, RTCRayHit& ray) {
    rtcIntersect1(scene, &query.context, &ray);
}
inline void closest(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRayHit8& rays) {
    rtcIntersect8(valid, scene, &query.context, &rays);
}
inline void any(RTCScene scene, EmbreeQuery& query, RTCRay& ray) {
    rtcOccluded1(scene, &query.context, &ray);
}
inline void any(const int* valid, RTCScene scene, EmbreeQuery& query, RTCRay8& rays) {
    rtcOccluded8(valid, scene, &query.context, &rays);
}

#endif

}  // namespace gg
