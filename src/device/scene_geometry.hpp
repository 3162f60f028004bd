// What hits refer to: every geometry has one id, the index of its record. Infinite planes and visible lights have ids of their
// own (ray_packet.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "device/primitives.hpp"
#include "device/world_splat.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Coordinates of rays up to which the device computes: builds of Embree that check, as Debian's, end the process at larger
/// ones and at what is not a number.
inline constexpr float kLargestReach = 1e18f;

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
  bool placed = false;         ///< an instance of a mesh: normals and positions need world_from_mesh
  bool hidden = false;         ///< placed, but scaled to nothing
  std::uint32_t instance = 0;  ///< index in Scene::instances (meshes; other kinds keep one per primitive)
  const Mesh* mesh = nullptr;  ///< world space, or mesh space where placed
  std::array<const std::vector<UvGradient>*, 2> uv_gradients{};  ///< by set of uvs, per triangle; null: the mesh lacks the set
  const void* primitives = nullptr;                              ///< PrimitiveTable of the kind
  const std::vector<std::uint32_t>* instance_of_primitive = nullptr;
  bool one_material = true;     ///< shared by all that has this record
  float reach = kLargestReach;  ///< up to where coordinates of rays stay within kLargestReach in mesh space, too, where placed
  Affine3f world_from_mesh;
  Mat3f normal_from_mesh{1.0f};  ///< inverse transpose of the linear part
};

/// Primitives of one kind, all instances of the scene together, with what each belongs to.
template <class Primitive>
struct PrimitiveTable {
  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> instance;  ///< index in Scene::instances, per primitive
  std::vector<float> transmittance;     ///< the share of a shadow ray's light that passes, per primitive; 0: opaque
  bool see_through = false;             ///< any transmittance > 0
};

struct PrimitiveTables {
  PrimitiveTable<WorldSphere> spheres;
  PrimitiveTable<WorldCylinder> cylinders;
  PrimitiveTable<WorldRing> rings;
  PrimitiveTable<WorldBox> boxes;
};

/// A mesh that changes its shape, as it is at the moment, in world space.
struct PosedMesh {
  std::uint32_t record;
  Mesh mesh;
  std::array<std::vector<UvGradient>, 2> uv_gradients;
  bool mirrored;  ///< its triangles' corners are the other way round than in the scene's mesh
};

/// The splats that one instance shows.
struct SplatSet {
  std::uint32_t instance;  ///< index in Scene::instances
  const Splats* splats;
  Mat3f local_from_world;  ///< takes directions to the shape's axes
};

/// All splats of the scene, set by set, in the order of their shapes.
struct SplatTable {
  std::vector<WorldSplat> splats;
  std::vector<SplatSet> sets;
};

struct WorldPlaneRecord {
  WorldPlane plane;
  std::uint32_t instance;
  float transmittance;  ///< the share of a shadow ray's light that passes; 0: opaque
};

struct SceneGeometry {
  const Scene* scene = nullptr;
  float reach = kLargestReach;     ///< the largest coordinate of rays: the least of all records
  float size = 1.0f;               ///< the largest coordinate of what is there at the first frame, planes left out
  float radius = 1.0f;             ///< half the diagonal of the same
  bool tachyon = false;            ///< Tachyon's conventions (scene.encoding): box normals, mirror end, visible lights
  float secondary_t_near = 1e-4f;  ///< at least so far from their surface do secondary rays start

  std::vector<GeometryRecord> records;
  std::vector<std::unique_ptr<Mesh>> flattened;                                 ///< world-space copies of fixed meshes
  std::map<std::pair<const Mesh*, int>, std::vector<UvGradient>> uv_gradients;  ///< by mesh and set
  std::vector<std::unique_ptr<PosedMesh>> posed;
  PrimitiveTables fixed_tables, moving_tables;
  SplatTable splats;
  std::vector<WorldPlaneRecord> planes;
  std::vector<WorldSphere> visible_lights;  ///< by light; radius 0: not visible
  bool any_visible_light = false;
  bool hides_from_cameras = false, hides_from_shadows = false;  ///< whether any instance is hidden from camera or shadow rays
  bool has_shadows = false;                                     ///< whether any instance casts a shadow
  std::vector<bool> instance_moves;
};

}  // namespace lippmann
