// Analytic primitives as Embree user geometries, with one geometry per kind of primitive.
#pragma once

#include "device/embree_shim.hpp"
#include "device/scene_geometry.hpp"

namespace lippmann {

/// Returns a committed geometry that reads `table`, which must outlive the geometry, at the same address.
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldSphere>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldCylinder>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldRing>& table);
EmbreeGeometry make_user_geometry(RTCDevice device, PrimitiveTable<WorldBox>& table);

/// Updates the bounds of a geometry whose primitives have moved. Commit the scene afterwards. The number of primitives must be
/// unchanged.
void update_user_geometry(const EmbreeGeometry& geometry);

}  // namespace lippmann
