// What Embree holds of a scene.
//
// Two Embree scenes, traced one after the other with the same packet: `fixed` (built once: everything that never moves, meshes
// flattened to world space, meshes that many instances share as Embree instances) and `moving` (rebuilt per frame over
// instances and moving primitives; its meshes are built once). Every geometry of both has one id, the index of its
// GeometryRecord. Meshes that change their shape are geometries of `moving` whose vertices are written anew per frame; their
// trees are built once, of the first frame of the animation, and fitted to every other: the same bits whatever came before.
// Infinite planes lie outside Embree: they are met first and shorten the rays.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "device/embree_device.hpp"
#include "device/ray_scene.hpp"

namespace lippmann {

/// The tables of one of the two scenes.
struct PrimitiveGeometries {
  EmbreeGeometry spheres, cylinders, rings, boxes;
};

struct RayScene::Embree {
  EmbreeMemory memory;  ///< before the device, which reports to it
  EmbreeDevice device;
  int native_width = 16;
  EmbreeScene fixed, moving, splats;
  bool has_fixed = false, has_moving = false;
  std::map<std::pair<int, int>, EmbreeScene> mesh_scenes;  ///< by shape and material index
  PrimitiveGeometries fixed_primitives, moving_primitives;
  std::vector<std::unique_ptr<ShadowCaster>> shadow_casters;  ///< one for each mesh that is not opaque
  std::vector<EmbreeGeometry> placed;                         ///< by record id; the Embree instances that may move
  std::vector<int> moving_records;                            ///< ids of records in `moving` that are placed meshes
  std::vector<EmbreeGeometry> posed;  ///< as SceneGeometry::posed; vertices are copies: Embree reads beyond the last one
};

/// What building and moving a scene have to do with: its geometry and what Embree holds of it.
struct BuiltScene {
  SceneGeometry& geometry;
  RayScene::Embree& embree;
};

/// Fills both; `embree` has a device.
void build_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ShadowMaterials& materials,
                 const ThreadPool& pool);

/// Moves everything to where `resolved` has it.
void move_scene(const BuiltScene& scene, const ResolvedScene& resolved, const ThreadPool& pool);

}  // namespace lippmann
