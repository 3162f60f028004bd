// Properties of emissive meshes that do not depend on the frame: whether they are closed, and how bright each triangle is under
// its part of an emissive texture. Motion does not change them, so they are computed once per scene.
#pragma once

#include <span>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "shading/closed_mesh.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"

namespace lippmann {

/// A mesh with an emissive material.
struct Emitter {
  BodyFacing closed = BodyFacing::kNone;  ///< facing of the mesh in its own space, before it is placed or posed
  float luminance = 0.0f;                 ///< luminance of the emitted radiance without textures
  std::vector<float> by_triangle;         ///< mean luminance of each triangle, > 0; empty without an emissive texture
  float of(std::size_t triangle) const { return by_triangle.empty() ? luminance : by_triangle[triangle]; }
};

class Emitters {
 public:
  Emitters() = default;
  /// `materials` and `textures` are indexed like those of the scene.
  Emitters(const Scene& scene, std::span<const WhittedMaterial> materials, std::span<const DeviceTexture> textures,
           const ThreadPool& pool);

  /// Returns null if the instance is not an emissive mesh. Instances of the same shape and material share the result.
  const Emitter* of(std::size_t instance) const {
    return of_instance_[instance] < 0 ? nullptr : &emitters_[static_cast<std::size_t>(of_instance_[instance])];
  }

 private:
  std::vector<int> of_instance_;  ///< indices into emitters_; -1 without an emitter
  std::vector<Emitter> emitters_;
};

/// Returns the mean RGB of a map over a triangle of a mesh, from at most four lookups at the mip level where the triangle is
/// two texels wide or high. The lookups cover the triangle and a small margin. Returns white if the mesh has no coordinates for
/// the map.
Vec3f mean_over_triangle(const TextureMap& map, const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle);

}  // namespace lippmann
