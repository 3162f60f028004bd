// Where the vertices of meshes that change their shape are at a given time: morph targets, then skins.
//
// Such a mesh is not placed by its node's transform but posed vertex by vertex, in world space.
#pragma once

#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Whether the instance's mesh is posed: has a skin, or morph targets.
bool is_posed(const Scene& scene, const Instance& instance);

/// Whether what each instance shows ever moves or changes its shape.
std::vector<bool> moving_instances(const Scene& scene);

struct PosedVertex {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};   ///< unit length; 0 where the mesh has none
  Vec4f tangent{0.0f};  ///< as Mesh::tangents; 0 where the mesh has none
  bool operator==(const PosedVertex&) const = default;
};

/// The pose of one instance for which is_posed, at one time. Vertices may be asked for from several threads at once.
class MeshPose {
 public:
  /// Coordinates beyond it, and those that are not numbers, are given as this.
  static constexpr float kReach = 1e18f;

  /// `scene` must have passed validate() and must outlive this, as must `resolved`.
  MeshPose(const Scene& scene, const Instance& instance, const ResolvedScene& resolved);

  Vec3f position(std::size_t vertex) const;
  /// The normal lies on the side from which the triangles' corners, as they are in the mesh, are counter-clockwise.
  PosedVertex vertex(std::size_t vertex) const;

  /// Whether the pose mirrors the mesh, judged by its first joint or its node: then counter-clockwise is the inner side.
  bool mirrors() const;

 private:
  struct Weighted {
    const MorphTarget* target;
    float weight;
  };

  Affine3f world_from_vertex(std::size_t vertex) const;
  Vec3f morphed_position(std::size_t vertex) const;

  const Mesh& mesh_;
  std::vector<Weighted> targets_;  ///< those with a weight
  bool has_skin_;
  std::vector<Affine3f> world_from_mesh_;  ///< by joint, or the node's alone
};

}  // namespace lippmann
