#include "device/user_geometry.hpp"

#include "device/builder_tasks.hpp"

namespace lippmann {
namespace {

template <class Primitive>
void bounds_callback(const RTCBoundsFunctionArguments* args) {
  const BuilderCall call;
  const auto& table = *static_cast<const PrimitiveTable<Primitive>*>(args->geometryUserPtr);
  Bounds3f b = bounds(table.primitives[args->primID]);
  const Vec3f size = b.size();
  const float extent = size.x + size.y + size.z;
  if (!(extent > 0.0f && std::isfinite(extent))) b = {};  // no ray can hit a primitive scaled to 0, so its bounds are empty
  // Without padding, rays that graze the exact surface could miss the rounded bounds.
  const Vec3f pad = 1e-6f * glm::max(glm::abs(b.lower), glm::abs(b.upper));
  args->bounds_o->lower_x = b.lower.x - pad.x, args->bounds_o->upper_x = b.upper.x + pad.x;
  args->bounds_o->lower_y = b.lower.y - pad.y, args->bounds_o->upper_y = b.upper.y + pad.y;
  args->bounds_o->lower_z = b.lower.z - pad.z, args->bounds_o->upper_z = b.upper.z + pad.z;
}

/// A packet of n rays in Embree's layout: 12 arrays of n words for the rays, then 8 for the hits.
struct PacketView {
  float* words;
  unsigned n;
  LIPPMANN_INLINE float* field(unsigned index) const { return words + index * n; }
  LIPPMANN_INLINE LaneRay ray(unsigned i) const {
    return {words[i],         words[n + i],     words[2 * n + i], words[4 * n + i],
            words[5 * n + i], words[6 * n + i], words[3 * n + i], words[8 * n + i]};
  }
};

template <class Primitive>
LIPPMANN_INLINE void intersect_lanes(const Primitive& primitive, const int* valid, PacketView packet, unsigned n,
                                     unsigned prim_id, unsigned geom_id, unsigned inst_id) {
  packet.n = n;
  float* tfar = packet.field(8);
  auto* prim = reinterpret_cast<unsigned*>(packet.field(17));
  auto* geom = reinterpret_cast<unsigned*>(packet.field(18));
  auto* inst = reinterpret_cast<unsigned*>(packet.field(19));
#pragma GCC ivdep
  for (unsigned i = 0; i < n; ++i) {
    const float t = distance(primitive, packet.ray(i));
    const bool hit = (valid[i] != 0) & (t < tfar[i]);
    tfar[i] = hit ? t : tfar[i];
    prim[i] = hit ? prim_id : prim[i];
    geom[i] = hit ? geom_id : geom[i];
    inst[i] = hit ? inst_id : inst[i];
  }
}

template <class Primitive>
LIPPMANN_INLINE void occlude_lanes(const Primitive& primitive, const int* valid, PacketView packet, unsigned n) {
  packet.n = n;
  float* tfar = packet.field(8);
#pragma GCC ivdep
  for (unsigned i = 0; i < n; ++i) {
    const bool hit = (valid[i] != 0) & crosses(primitive, packet.ray(i));
    tfar[i] = hit ? -kInfinity : tfar[i];
  }
}

template <class Primitive>
LIPPMANN_INLINE void intersect_callback(const RTCIntersectFunctionNArguments* args) {
  const auto& table = *static_cast<const PrimitiveTable<Primitive>*>(args->geometryUserPtr);
  const Primitive primitive = table.primitives[args->primID];
  const PacketView packet{reinterpret_cast<float*>(args->rayhit), args->N};
  const unsigned inst = args->context->instID[0];
  if (args->N == kLanes)
    intersect_lanes(primitive, args->valid, packet, kLanes, args->primID, args->geomID, inst);
  else
    intersect_lanes(primitive, args->valid, packet, args->N, args->primID, args->geomID, inst);
}

/// Lets shadow rays pass a transparent primitive. Each crossing reduces a ray's transmittance. The id of a ray is its lane
/// (ShadowContext).
template <class Primitive>
void filter_lanes(const RTCOccludedFunctionNArguments* args, const Primitive& primitive, float transmittance) {
  const PacketView packet{reinterpret_cast<float*>(args->ray), args->N};
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  const auto* id = reinterpret_cast<const unsigned*>(packet.field(10));
  for (unsigned i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    LaneRay ray = packet.ray(i);
    for (int crossing = 0; crossing < 2; ++crossing) {  // each primitive has at most two crossings
      ray.t_near = distance(primitive, ray);
      if (!(ray.t_near < kInfinity)) break;
      context->transmittance[id[i]] *= transmittance;
    }
  }
}

template <class Primitive>
LIPPMANN_INLINE void occluded_callback(const RTCOccludedFunctionNArguments* args) {
  const auto& table = *static_cast<const PrimitiveTable<Primitive>*>(args->geometryUserPtr);
  const Primitive primitive = table.primitives[args->primID];
  if (table.see_through && table.transmittance[args->primID] > 0.0f)
    return filter_lanes(args, primitive, table.transmittance[args->primID]);
  const PacketView packet{reinterpret_cast<float*>(args->ray), args->N};
  if (args->N == kLanes)
    occlude_lanes(primitive, args->valid, packet, kLanes);
  else
    occlude_lanes(primitive, args->valid, packet, args->N);
}

// Multiversioned functions cannot be templates, so each kind of primitive has two functions of its own.
LIPPMANN_MULTIVERSION void intersect_sphere(const RTCIntersectFunctionNArguments* a) { intersect_callback<WorldSphere>(a); }
LIPPMANN_MULTIVERSION void occlude_sphere(const RTCOccludedFunctionNArguments* a) { occluded_callback<WorldSphere>(a); }
LIPPMANN_MULTIVERSION void intersect_cylinder(const RTCIntersectFunctionNArguments* a) { intersect_callback<WorldCylinder>(a); }
LIPPMANN_MULTIVERSION void occlude_cylinder(const RTCOccludedFunctionNArguments* a) { occluded_callback<WorldCylinder>(a); }
LIPPMANN_MULTIVERSION void intersect_ring(const RTCIntersectFunctionNArguments* a) { intersect_callback<WorldRing>(a); }
LIPPMANN_MULTIVERSION void occlude_ring(const RTCOccludedFunctionNArguments* a) { occluded_callback<WorldRing>(a); }
LIPPMANN_MULTIVERSION void intersect_box(const RTCIntersectFunctionNArguments* a) { intersect_callback<WorldBox>(a); }
LIPPMANN_MULTIVERSION void occlude_box(const RTCOccludedFunctionNArguments* a) { occluded_callback<WorldBox>(a); }

template <class Primitive>
EmbreeGeometry make(RTCDevice device, PrimitiveTable<Primitive>& table, RTCIntersectFunctionN intersect_function,
                    RTCOccludedFunctionN occluded_function) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(table.primitives.size()));
  rtcSetGeometryUserData(geometry.get(), &table);
  rtcSetGeometryBoundsFunction(geometry.get(), bounds_callback<Primitive>, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), intersect_function);
  rtcSetGeometryOccludedFunction(geometry.get(), occluded_function);
  rtcSetGeometryMask(geometry.get(), ~0u);
  rtcCommitGeometry(geometry.get());
  return geometry;
}

}  // namespace

EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldSphere>& table) {
  return make(device, table, intersect_sphere, occlude_sphere);
}
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldCylinder>& table) {
  return make(device, table, intersect_cylinder, occlude_cylinder);
}
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldRing>& table) {
  return make(device, table, intersect_ring, occlude_ring);
}
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldBox>& table) {
  return make(device, table, intersect_box, occlude_box);
}

void update_user_geometry(const EmbreeGeometry& geometry) { rtcCommitGeometry(geometry.get()); }

}  // namespace lippmann
