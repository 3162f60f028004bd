// Embree's representation of a scene.
//
// There are two Embree scenes, `fixed` and `moving`. Each packet is traced through both.
// - `fixed` is built once. It holds everything that never moves: meshes flattened to world space, and meshes with many
//   instances as Embree instances.
// - `moving` is rebuilt for each frame. It holds Embree instances, moving primitives and deforming meshes. The trees of
//   deforming meshes are built for the first frame of the animation and refitted for all others, so the result does not depend
//   on the order of frames.
//
// The id of a geometry is the index of its GeometryRecord in both scenes. Infinite planes are not part of Embree's scenes. They
// are intersected first and shorten the rays.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "device/embree_device.hpp"
#include "device/ray_scene.hpp"

namespace lippmann {

/// The geometries of analytic primitives in one of the two Embree scenes, `fixed` or `moving`.
struct PrimitiveGeometries {
  EmbreeGeometry spheres, cylinders, rings, boxes;
};

struct RayScene::Embree {
  EmbreeMemory memory;  ///< declared before the device, because the device reports to it until destroyed
  EmbreeDevice device;
  int native_width = 16;
  EmbreeScene fixed, moving, splats;
  bool has_fixed = false, has_moving = false;
  std::map<std::pair<int, int>, EmbreeScene> mesh_scenes;  ///< the key is (shape index, material index)
  PrimitiveGeometries fixed_primitives, moving_primitives;
  std::vector<std::unique_ptr<ShadowCaster>> shadow_casters;
  std::vector<EmbreeGeometry> placed;
  std::vector<int> moving_records;
  /// Embree reads beyond the last vertex, so the vertices are padded copies.
  std::vector<EmbreeGeometry> posed;
};

/// References to the scene's geometry and to Embree's scenes, which are built once and updated for each frame.
struct BuiltScene {
  SceneGeometry& geometry;
  RayScene::Embree& embree;
};

/// Builds the geometry and Embree's scenes. `scene.embree` must have a device.
void build_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials,
                 const ThreadPool& pool);

void move_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ThreadPool& pool);

}  // namespace lippmann
