// The data that hits refer to. The id of a geometry is the index of its GeometryRecord. Infinite planes and visible lights have
// their own ids (ray_packet.hpp).
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

/// Limit of ray coordinates. Embree builds with assertions, such as Debian's, abort at larger coordinates and at NaN.
inline constexpr float kLargestReach = 1e18f;

enum class GeometryKind : std::uint8_t { kMesh, kSpheres, kCylinders, kRings, kBoxes };

/// Gradient of texture coordinates across a triangle in its mesh's space, and the facet's normal. Texture filtering reads them
/// at every hit.
struct UvGradient {
  Vec3f du, dv;  ///< gradients of u and v within the facet; 0 for degenerate triangles
  Vec3f normal;  ///< unit length; 0 for degenerate triangles
};

/// Describes the object that a geometry id stands for.
struct GeometryRecord {
  GeometryKind kind = GeometryKind::kMesh;
  bool placed = false;  ///< whether this is an Embree instance of a mesh, whose normals and positions need world_from_mesh
  bool hidden = false;  ///< whether this is a placed mesh scaled to practically 0
  std::uint32_t instance = 0;  ///< index in Scene::instances (meshes only; other kinds have one per primitive)
  const Mesh* mesh = nullptr;  ///< vertices are in world space, or in mesh space if `placed` is set
  /// Gradients per triangle, by uv set; null if the mesh lacks the set.
  std::array<const std::vector<UvGradient>*, 2> uv_gradients{};
  const void* primitives = nullptr;  ///< PrimitiveTable of this kind, for analytic shapes
  const std::vector<std::uint32_t>* instance_of_primitive = nullptr;
  bool one_material = true;     ///< all instances of this record have the same material
  float reach = kLargestReach;  ///< for placed meshes: the largest ray coordinate that stays within kLargestReach in mesh space
  Affine3f world_from_mesh;
  Mat3f normal_from_mesh{1.0f};  ///< inverse transpose of the linear part
};

/// All primitives of one kind in the scene, with their instances.
template <class Primitive>
struct PrimitiveTable {
  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> instance;  ///< index in Scene::instances, per primitive
  std::vector<float> transmittance;     ///< share of light that shadow rays pass through, per primitive; 0: opaque
  bool see_through = false;             ///< whether any transmittance is > 0
};

struct PrimitiveTables {
  PrimitiveTable<WorldSphere> spheres;
  PrimitiveTable<WorldCylinder> cylinders;
  PrimitiveTable<WorldRing> rings;
  PrimitiveTable<WorldBox> boxes;
};

/// A deforming mesh in its current pose, in world space.
struct PosedMesh {
  std::uint32_t record;
  Mesh mesh;
  std::array<std::vector<UvGradient>, 2> uv_gradients;
  bool mirrored;  ///< whether the triangles have the opposite winding to those of the scene's mesh
};

/// The splats of one instance.
struct SplatSet {
  std::uint32_t instance;  ///< index in Scene::instances
  const Splats* splats;
  Mat3f local_from_world;  ///< maps directions to the shape's axes
};

/// All splats of the scene, set by set, in the order of their shapes.
struct SplatTable {
  std::vector<WorldSplat> splats;
  std::vector<SplatSet> sets;
};

struct WorldPlaneRecord {
  WorldPlane plane;
  std::uint32_t instance;
  float transmittance;  ///< share of light that shadow rays pass through; 0: opaque
};

struct SceneGeometry {
  const Scene* scene = nullptr;
  float reach = kLargestReach;  ///< largest allowed ray coordinate: the minimum over all records
  float size = 1.0f;            ///< largest coordinate in the first frame, without planes
  float radius = 1.0f;          ///< half the diagonal of the scene in the first frame, without planes
  bool tachyon = false;  ///< Tachyon's conventions (scene.encoding): box normals, mirrors at the depth limit, visible lights
  float secondary_t_near = 1e-4f;  ///< start distance of secondary rays

  std::vector<GeometryRecord> records;
  std::vector<std::unique_ptr<Mesh>> flattened;                                 ///< world-space copies of fixed meshes
  std::map<std::pair<const Mesh*, int>, std::vector<UvGradient>> uv_gradients;  ///< by mesh and uv set
  std::vector<std::unique_ptr<PosedMesh>> posed;
  PrimitiveTables fixed_tables, moving_tables;
  SplatTable splats;
  std::vector<WorldPlaneRecord> planes;
  std::vector<WorldSphere> visible_lights;  ///< by light; radius 0: invisible
  bool any_visible_light = false;
  bool hides_from_cameras = false, hides_from_shadows = false;  ///< whether any instance is hidden from camera or shadow rays
  bool has_shadows = false;                                     ///< whether any instance casts a shadow
  std::vector<bool> instance_moves;
};

}  // namespace lippmann
