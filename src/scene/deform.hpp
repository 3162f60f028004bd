// Computes the vertices of deforming meshes at a given time: first the morph targets are applied, then the skin.
//
// The results are in world space. The transform of the instance's node is already included.
#pragma once

#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// Returns whether the instance's mesh has a skin or morph targets.
bool is_posed(const Scene& scene, const Instance& instance);

/// Returns for each instance whether its position or shape ever changes.
std::vector<bool> moving_instances(const Scene& scene);

struct PosedVertex {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};   ///< unit length; 0 if the mesh has no normals
  Vec4f tangent{0.0f};  ///< as in Mesh::tangents; 0 if the mesh has no tangents
  bool operator==(const PosedVertex&) const = default;
};

/// The deformed mesh of one instance at one time. Requires is_posed(). Thread-safe.
class MeshPose {
 public:
  /// The largest coordinate of a result. Larger coordinates and NaN are clamped.
  static constexpr float kReach = 1e18f;

  /// `scene` must have passed validate(). `scene` and `resolved` must outlive this object.
  MeshPose(const Scene& scene, const Instance& instance, const ResolvedScene& resolved);

  Vec3f position(std::size_t vertex) const;
  /// Returns the position, normal and tangent of a vertex. The normal points to the side from which the triangles appear
  /// counter-clockwise.
  PosedVertex vertex(std::size_t vertex) const;

  /// Returns whether the mesh is mirrored, so that counter-clockwise triangles face inwards. Only the transform of the first
  /// joint, or of the node if there is no skin, decides.
  bool mirrors() const;

 private:
  struct Weighted {
    const MorphTarget* target;
    float weight;
  };

  Affine3f world_from_vertex(std::size_t vertex) const;
  Vec3f morphed_position(std::size_t vertex) const;

  const Mesh& mesh_;
  std::vector<Weighted> targets_;  ///< morph targets with a non-zero weight
  bool has_skin_;
  std::vector<Affine3f> world_from_mesh_;  ///< one transform per joint; without a skin, only the node's transform
};

}  // namespace lippmann
