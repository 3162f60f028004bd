// The data that hits refer to. The id of a geometry is the index of its GeometryRecord. Infinite planes and visible lights have
// other ids (ray_packet.hpp).
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

/// Limit of the coordinates of rays. Builds of Embree with assertions, such as Debian's, abort at larger coordinates and at
/// NaN.
inline constexpr float kLargestReach = 1e18f;

enum class GeometryKind : std::uint8_t { kMesh, kSpheres, kCylinders, kRings, kBoxes };

/// The facet's normal and the gradients of texture coordinates on a triangle, in mesh space.
struct UvGradient {
  Vec3f du, dv;  ///< gradients of u and v within the facet; 0 if the triangle is degenerate
  Vec3f normal;  ///< unit length; 0 if the triangle is degenerate
};

struct GeometryRecord {
  GeometryKind kind = GeometryKind::kMesh;
  /// True for an Embree instance of a mesh, whose normals and positions must be transformed by world_from_mesh.
  bool placed = false;
  bool hidden = false;  ///< true for a placed mesh whose scale is practically 0
  std::uint32_t instance = 0;
  const Mesh* mesh = nullptr;  ///< its vertices are in mesh space if `placed` is set, otherwise in world space
  /// For each uv set, one gradient per triangle; null if the mesh lacks the set.
  std::array<const std::vector<UvGradient>*, 2> uv_gradients{};
  const void* primitives = nullptr;  ///< analytic shapes only: the PrimitiveTable of this kind
  const std::vector<std::uint32_t>* instance_of_primitive = nullptr;
  bool one_material = true;     ///< whether all instances of this record have the same material
  float reach = kLargestReach;  ///< limit of world coordinates of rays, so that they stay within kLargestReach in mesh space
  Affine3f world_from_mesh;
  Mat3f normal_from_mesh{1.0f};  ///< inverse transpose of world_from_mesh.linear
};

/// All fixed or all moving primitives of one kind.
template <class Primitive>
struct PrimitiveTable {
  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> instance;
  std::vector<float> transmittance;  ///< transmittance of each primitive for shadow rays; 0: opaque
  bool see_through = false;          ///< whether any primitive has a transmittance > 0
};

struct PrimitiveTables {
  PrimitiveTable<WorldSphere> spheres;
  PrimitiveTable<WorldCylinder> cylinders;
  PrimitiveTable<WorldRing> rings;
  PrimitiveTable<WorldBox> boxes;
};

struct PosedMesh {
  std::uint32_t record;
  Mesh mesh;
  std::array<std::vector<UvGradient>, 2> uv_gradients;
  bool mirrored;  ///< whether the triangles have the opposite winding from those in the scene's mesh
};

struct SplatSet {
  std::uint32_t instance;
  const Splats* splats;
  Mat3f local_from_world;  ///< maps directions from world space to the axes of the shape
};

/// The splats of all sets, set by set. Within a set, splats are in the order of the scene's shape.
struct SplatTable {
  std::vector<WorldSplat> splats;
  std::vector<SplatSet> sets;
};

struct WorldPlaneRecord {
  WorldPlane plane;
  std::uint32_t instance;
  float transmittance;  ///< transmittance of the plane for shadow rays; 0: opaque
};

struct SceneGeometry {
  const Scene* scene = nullptr;
  float reach = kLargestReach;  ///< largest allowed coordinate of rays: the minimum over all records
  float size = 1.0f;            ///< largest coordinate of the scene in the first frame, without planes
  float radius = 1.0f;
  /// Whether Tachyon's conventions apply to box normals, mirrors at the depth limit and visible lights (Scene::encoding).
  bool tachyon = false;
  float secondary_t_near = 1e-4f;  ///< distance at which secondary rays start

  std::vector<GeometryRecord> records;
  std::vector<std::unique_ptr<Mesh>> flattened;
  std::map<std::pair<const Mesh*, int>, std::vector<UvGradient>> uv_gradients;
  std::vector<std::unique_ptr<PosedMesh>> posed;
  PrimitiveTables fixed_tables, moving_tables;
  SplatTable splats;
  std::vector<WorldPlaneRecord> planes;
  std::vector<WorldSphere> visible_lights;  ///< one sphere per light; radius 0: the light is invisible
  bool any_visible_light = false;
  /// Whether any instance is invisible to camera rays, and whether any is invisible to shadow rays.
  bool hides_from_cameras = false, hides_from_shadows = false;
  bool has_shadows = false;
  std::vector<bool> instance_moves;
};

}  // namespace lippmann
