#pragma once

#include <utility>
#include <vector>

#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

bool is_posed(const Scene& scene, const Instance& instance);

std::vector<bool> moving_instances(const Scene& scene);

struct PosedVertex {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};
  Vec4f tangent{0.0f};
  bool operator==(const PosedVertex&) const = default;
};

/// The deformed mesh of one instance at one time. Requires is_posed(). Thread-safe.
class MeshPose {
 public:
  /// Larger coordinates and NaN are clamped to this.
  static constexpr float kReach = 1e18f;

  MeshPose(const Scene& scene, const Instance& instance, const ResolvedScene& resolved);

  Vec3f position(std::size_t vertex) const;
  /// Returns the position, normal and tangent of a vertex. The normal points to the side from which the triangles appear
  /// counter-clockwise.
  PosedVertex vertex(std::size_t vertex) const;

  /// Returns whether the mesh is mirrored, as decided by the transform of the first joint, or of the node if there is no skin.
  bool mirrors() const;

 private:
  struct Weighted {
    const MorphTarget* target;
    float weight;
  };

  Affine3f world_from_vertex(std::size_t vertex) const;
  Vec3f morphed_position(std::size_t vertex) const;

  const Mesh& mesh_;
  std::vector<Weighted> targets_;
  bool has_skin_;
  std::vector<Affine3f> world_from_mesh_;
};

}  // namespace lippmann
