// Analytic primitives as Embree user geometry: one geometry per kind, callbacks that test one primitive against a whole packet.
// Private to src/trace.
#pragma once

#include <vector>

#include "trace/embree_shim.hpp"
#include "trace/primitives.hpp"

namespace lippmann {

/// Primitives of one kind, all instances of the scene together, with what each belongs to.
template <class Primitive>
struct PrimitiveTable {
  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> instance;  ///< index in Scene::instances, per primitive
  std::vector<float> transmittance;     ///< of shadow rays, per primitive; 0: opaque
  bool see_through = false;             ///< any transmittance > 0
};

/// A committed geometry that reads `table`, which must outlive it at the same address.
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldSphere>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldCylinder>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldRing>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldBox>& table);

/// Call after the primitives of `table` have moved (their number must not change), before committing the scene.
void update_user_geometry(const EmbreeGeometry& geometry);

}  // namespace lippmann
