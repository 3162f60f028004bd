// Embree's representation of a scene.
//
// There are two Embree scenes, traced one after the other with the same packet. `fixed` is built once and holds everything that
// never moves: meshes flattened to world space, and meshes with many instances as Embree instances. `moving` is rebuilt per
// frame over instances and moving primitives; its meshes are built once. Geometry ids are unique over both scenes: the id is
// the index of the geometry's GeometryRecord. Deforming meshes are geometries of `moving` with new vertices per frame. Their
// trees are built for the first frame of the animation and refitted for every other frame, so the result does not depend on the
// order of frames. Infinite planes are not part of Embree: they are intersected first and shorten the rays.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "device/embree_device.hpp"
#include "device/ray_scene.hpp"

namespace lippmann {

/// Primitive geometries of one of the two scenes.
struct PrimitiveGeometries {
  EmbreeGeometry spheres, cylinders, rings, boxes;
};

struct RayScene::Embree {
  EmbreeMemory memory;  ///< declared before the device, which reports to it
  EmbreeDevice device;
  int native_width = 16;
  EmbreeScene fixed, moving, splats;
  bool has_fixed = false, has_moving = false;
  std::map<std::pair<int, int>, EmbreeScene> mesh_scenes;  ///< by shape and material index
  PrimitiveGeometries fixed_primitives, moving_primitives;
  std::vector<std::unique_ptr<ShadowCaster>> shadow_casters;  ///< one per mesh that is not opaque
  std::vector<EmbreeGeometry> placed;                         ///< the Embree instances that may move, by record id
  std::vector<int> moving_records;                            ///< ids of records in `moving` that are placed meshes
  std::vector<EmbreeGeometry> posed;  ///< in the order of SceneGeometry::posed; these have copies of the vertices, because
                                      ///< Embree reads beyond the last vertex
};

/// The data that building and moving a scene need: its geometry and Embree's data.
struct BuiltScene {
  SceneGeometry& geometry;
  RayScene::Embree& embree;
};

/// Builds the geometry and Embree's scenes. `scene.embree` must have a device.
void build_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials,
                 const ThreadPool& pool);

/// Moves all objects to their places in `resolved`.
void move_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ThreadPool& pool);

}  // namespace lippmann
