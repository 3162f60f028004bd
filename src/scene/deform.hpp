// Vertex positions of deforming meshes at a given time: morph targets, then skins.
//
// The vertices are posed in world space; the node's transform is not applied afterwards.
#pragma once

#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Returns whether the instance's mesh is posed: whether it has a skin or morph targets.
bool is_posed(const Scene& scene, const Instance& instance);

/// Returns for each instance whether it ever moves or deforms.
std::vector<bool> moving_instances(const Scene& scene);

struct PosedVertex {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};   ///< unit length; 0 if the mesh has none
  Vec4f tangent{0.0f};  ///< as in Mesh::tangents; 0 if the mesh has none
  bool operator==(const PosedVertex&) const = default;
};

/// The pose of one instance, for which is_posed() is true, at one time. Thread-safe.
class MeshPose {
 public:
  /// The largest coordinate. Larger coordinates and NaN are clamped.
  static constexpr float kReach = 1e18f;

  /// `scene` must have passed validate(). `scene` and `resolved` must outlive this object.
  MeshPose(const Scene& scene, const Instance& instance, const ResolvedScene& resolved);

  Vec3f position(std::size_t vertex) const;
  /// Returns a posed vertex. Its normal lies on the side from which the triangles, in the mesh's own winding, are
  /// counter-clockwise.
  PosedVertex vertex(std::size_t vertex) const;

  /// Returns whether the pose mirrors the mesh, judged by its first joint or its node. Counter-clockwise triangles then face
  /// inwards.
  bool mirrors() const;

 private:
  struct Weighted {
    const MorphTarget* target;
    float weight;
  };

  Affine3f world_from_vertex(std::size_t vertex) const;
  Vec3f morphed_position(std::size_t vertex) const;

  const Mesh& mesh_;
  std::vector<Weighted> targets_;  ///< targets with a non-zero weight
  bool has_skin_;
  std::vector<Affine3f> world_from_mesh_;  ///< one transform per joint, or only that of the node
};

}  // namespace lippmann
