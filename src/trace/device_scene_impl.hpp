// What a DeviceScene holds, for the kernels of this part. Private to src/trace.
//
// Two Embree scenes, traced one after the other with the same packet: `fixed` (built once: everything that never moves, meshes
// flattened to world space, meshes that many instances share as Embree instances) and `moving` (rebuilt per frame over
// instances and moving primitives; its meshes are built once). Every geometry of both has one id, the index of its
// GeometryRecord. Meshes that change their shape are geometries of `moving` whose vertices are written anew per frame; their
// trees are built once, of the first frame of the animation, and fitted to every other: the same bits whatever came before.
// Infinite planes lie outside Embree: they are met first and shorten the rays.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "trace/device_scene.hpp"
#include "trace/embree_shim.hpp"
#include "trace/light_table.hpp"
#include "trace/materials.hpp"
#include "trace/shadow_filter.hpp"
#include "trace/texture.hpp"
#include "trace/user_geometry.hpp"
#include "transport/ggx_albedo.hpp"

namespace lippmann {

enum class GeometryKind : std::uint8_t { kMesh, kSpheres, kCylinders, kRings, kBoxes };

/// How texture coordinates change across a triangle, in its mesh's space, and its facet's normal: what filtering asks at every
/// hit.
struct UvGradient {
  Vec3f du, dv;  ///< gradients of u and v within the facet; 0 for triangles without area
  Vec3f normal;  ///< unit length; 0 for triangles without area
};

/// What a hit's geometry id leads to.
struct GeometryRecord {
  GeometryKind kind = GeometryKind::kMesh;
  bool placed = false;         ///< an Embree instance: normals and positions need world_from_mesh
  bool hidden = false;         ///< placed, but scaled to nothing
  std::uint32_t instance = 0;  ///< index in Scene::instances (meshes; other kinds keep one per primitive)
  const Mesh* mesh = nullptr;  ///< world space, or mesh space where placed
  std::array<const std::vector<UvGradient>*, 2> uv_gradients{};  ///< by set of uvs, per triangle; null: the mesh lacks the set
  const void* primitives = nullptr;                              ///< PrimitiveTable of the kind
  const std::vector<std::uint32_t>* instance_of_primitive = nullptr;
  bool one_material = true;    ///< shared by all that has this record
  float reach = kEmbreeReach;  ///< of rays that stay within kEmbreeReach when they are taken into mesh space, where placed
  Affine3f world_from_mesh;
  Mat3f normal_from_mesh{1.0f};  ///< inverse transpose of the linear part
};

/// The tables of one of the two Embree scenes.
struct PrimitiveTables {
  PrimitiveTable<WorldSphere> spheres;
  PrimitiveTable<WorldCylinder> cylinders;
  PrimitiveTable<WorldRing> rings;
  PrimitiveTable<WorldBox> boxes;
  EmbreeGeometry sphere_geometry, cylinder_geometry, ring_geometry, box_geometry;
};

/// A mesh that changes its shape, as it is at the moment, in world space.
struct PosedMesh {
  std::uint32_t record;
  Mesh mesh;
  EmbreeGeometry geometry;  ///< has vertices of its own: Embree reads beyond the last one
  std::array<std::vector<UvGradient>, 2> uv_gradients;
  bool mirrored;  ///< its triangles' corners are the other way round than in the scene's mesh
};

struct WorldPlaneRecord {
  WorldPlane plane;
  std::uint32_t instance;
  float transmittance;  ///< of shadow rays; 0: opaque
};

/// What only paths ask for.
struct PathTables {
  GgxAlbedo albedo;
  std::unique_ptr<LightTable> lights;  ///< of the frame
};

struct DeviceScene::Impl {
  const Scene* scene = nullptr;
  EmbreeDevice device;
  int native_width = 16;
  float reach = kEmbreeReach;  ///< of rays: the least of all records
  float size = 1.0f;           ///< the largest coordinate of what is there at the first frame, planes left out
  float radius = 1.0f;         ///< half the diagonal of the same

  EmbreeScene fixed, moving;
  bool has_fixed = false, has_moving = false;
  std::vector<GeometryRecord> records;
  std::vector<std::unique_ptr<Mesh>> flattened;                                 ///< world-space copies of fixed meshes
  std::map<std::pair<int, int>, EmbreeScene> mesh_scenes;                       ///< by shape and material index
  std::map<std::pair<const Mesh*, int>, std::vector<UvGradient>> uv_gradients;  ///< by mesh and set
  std::vector<std::unique_ptr<PosedMesh>> posed;
  PrimitiveTables fixed_tables, moving_tables;
  std::vector<std::unique_ptr<ShadowCaster>> shadow_casters;  ///< of meshes that are not opaque
  std::vector<EmbreeGeometry> placed_geometries;              ///< by record id; the Embree instances that may move
  std::vector<int> moving_records;                            ///< ids of records in `moving` that are placed meshes
  std::vector<WorldPlaneRecord> planes;
  std::vector<bool> instance_moves;

  MaterialTable materials;
  std::vector<std::uint32_t> material_of_instance;
  std::vector<WhittedLight> lights;
  std::unique_ptr<Environment> environment;
  std::unique_ptr<PathTables> path;  ///< where paths are traced
  std::vector<DeviceTexture> textures;
  bool tachyon = false;            ///< Tachyon's conventions (scene.encoding): box normals, mirror end, visible lights
  float secondary_t_near = 1e-4f;  ///< at least so far from their surface do secondary rays start
  bool any_visible_light = false;
};

}  // namespace lippmann
