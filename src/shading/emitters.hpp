// What is known of meshes that shine before any frame is made: whether they enclose a body, and how bright each triangle is by
// its own part of an emissive texture. Neither changes when things move, so that both are found once per scene.
#pragma once

#include <span>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "shading/closed_mesh.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"

namespace lippmann {

/// A mesh in a material that shines.
struct Emitter {
  BodyFacing closed = BodyFacing::kNone;  ///< of the mesh as the scene describes it, before it is placed or posed
  float luminance = 0.0f;                 ///< of the radiance that it emits, where no texture changes it
  std::vector<float> by_triangle;         ///< mean luminance of each triangle, > 0; empty: it has no emissive texture
  float of(std::size_t triangle) const { return by_triangle.empty() ? luminance : by_triangle[triangle]; }
};

class Emitters {
 public:
  Emitters() = default;
  /// materials: by index of the scene's; textures: likewise.
  Emitters(const Scene& scene, std::span<const WhittedMaterial> materials, std::span<const DeviceTexture> textures,
           const ThreadPool& pool);

  /// Null: the instance is no mesh, or does not shine. Instances of one shape and material share theirs.
  const Emitter* of(std::size_t instance) const {
    return of_instance_[instance] < 0 ? nullptr : &emitters_[static_cast<std::size_t>(of_instance_[instance])];
  }

 private:
  std::vector<int> of_instance_;  ///< into emitters_; -1: none
  std::vector<Emitter> emitters_;
};

/// Mean RGB of a map over a triangle of a mesh, from at most four look-ups: at the level of the texture at which it is
/// two texels wide or high, so that they see all of it and a little around it. White where the mesh has no coordinates
/// for it.
Vec3f mean_over_triangle(const TextureMap& map, const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle);

}  // namespace lippmann
