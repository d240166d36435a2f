#pragma once
// Embree 3 and 4 behind one set of names. Private to sim/: only world.cpp includes it.
//
// Embree 4 renamed the header, replaced the intersection context by optional arguments, and dropped
// the stream calls; packets of 4, 8 and 16 live in both, which is why we use those.

#if SCANCHOR_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace scanchor::embree {

#if SCANCHOR_EMBREE_MAJOR >= 4
/// What every query takes beside its rays. Without the coherent flag packets run at the speed of
/// single rays.
struct Query {
  RTCIntersectArguments arguments;
  explicit Query(bool coherent = true) {
    rtcInitIntersectArguments(&arguments);
    arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  }
};
inline void intersect(RTCScene scene, Query& q, RTCRayHit& r) {
  rtcIntersect1(scene, &r, &q.arguments);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit4& r) {
  rtcIntersect4(valid, scene, &r, &q.arguments);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit8& r) {
  rtcIntersect8(valid, scene, &r, &q.arguments);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit16& r) {
  rtcIntersect16(valid, scene, &r, &q.arguments);
}
#else
/// What every query takes beside its rays. Without the coherent flag packets run at the speed of
/// single rays.
struct Query {
  RTCIntersectContext context;
  explicit Query(bool coherent = true) {
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  }
};
inline void intersect(RTCScene scene, Query& q, RTCRayHit& r) {
  rtcIntersect1(scene, &q.context, &r);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit4& r) {
  rtcIntersect4(valid, scene, &q.context, &r);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit8& r) {
  rtcIntersect8(valid, scene, &q.context, &r);
}
inline void intersect(const int* valid, RTCScene scene, Query& q, RTCRayHit16& r) {
  rtcIntersect16(valid, scene, &q.context, &r);
}
#endif

}  // namespace scanchor::embree
