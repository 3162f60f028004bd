// Embree's representation of a scene.
//
// There are two Embree scenes, `fixed` and `moving`. Each packet is traced through both.
// - `fixed` is built once. It holds everything that never moves: meshes flattened to world space, and meshes with many
// instances as Embree instances.
// - `moving` is rebuilt for each frame. It holds Embree instances and moving primitives. The meshes of its instances are built
// once.
// - Deforming meshes belong to `moving` and get new vertices for each frame. Their trees are built for the first frame of the
// animation and refitted for all others, so the result does not depend on the order of frames.
//
// Ids of geometries are unique over both scenes: the id is the index of the GeometryRecord. Infinite planes are not part of
// Embree's scenes. They are intersected first and shorten the rays.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "device/embree_device.hpp"
#include "device/ray_scene.hpp"

namespace lippmann {

/// The geometries of analytic primitives in `fixed` or in `moving`.
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
  std::vector<std::unique_ptr<ShadowCaster>> shadow_casters;  ///< one per mesh geometry that is not opaque
  std::vector<EmbreeGeometry> placed;                         ///< Embree instances that may move; the index is the record id
  std::vector<int> moving_records;                            ///< record ids of the mesh instances in `moving`
  /// Deforming meshes in the order of SceneGeometry::posed; Embree reads beyond the last vertex, so they have padded copies of
  /// the vertices.
  std::vector<EmbreeGeometry> posed;
};

/// The data that are built and moved: the scene's geometry and Embree's scenes.
struct BuiltScene {
  SceneGeometry& geometry;
  RayScene::Embree& embree;
};

/// Builds the geometry and Embree's scenes. `scene.embree` must have a device.
void build_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials,
                 const ThreadPool& pool);

/// Moves all objects to their positions in `resolved`.
void move_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ThreadPool& pool);

}  // namespace lippmann
