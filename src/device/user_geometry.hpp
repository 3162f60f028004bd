// Analytic primitives as Embree user geometries: one geometry per kind, with callbacks that test one primitive against a whole
// packet.
#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"

namespace lippmann {

/// Return a committed geometry that reads `table`, which must outlive it at the same address.
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldSphere>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldCylinder>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldRing>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldBox>& table);

/// Call this after the primitives of `table` have moved and before committing the scene. Their number must not change.
void update_user_geometry(const EmbreeGeometry& geometry);

}  // namespace lippmann
