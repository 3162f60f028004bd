// Analytic primitives as Embree user geometry: one geometry per kind, callbacks that test one primitive against a whole packet.
#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"

namespace lippmann {

/// A committed geometry that reads `table`, which must outlive it at the same address.
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldSphere>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldCylinder>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldRing>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldBox>& table);

/// Call after the primitives of `table` have moved (their number must not change), before committing the scene.
void update_user_geometry(const EmbreeGeometry& geometry);

}  // namespace lippmann
