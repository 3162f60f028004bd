// Properties of emissive meshes: whether a mesh is closed, and the luminance of each triangle under an emissive texture. Motion
// does not change these properties, so they are computed once per scene.
#pragma once

#include <span>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/scene/scene.hpp"
#include "shading/closed_mesh.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"

namespace lippmann {

struct Emitter {
  BodyFacing closed = BodyFacing::kNone;  ///< facing of the mesh in its own space, before transforms and poses
  float luminance = 0.0f;                 ///< luminance of the emission without textures
  std::vector<float> by_triangle;  ///< mean luminance over each triangle, > 0; empty if the material has no emissive texture
  float of(std::size_t triangle) const { return by_triangle.empty() ? luminance : by_triangle[triangle]; }
};

class Emitters {
 public:
  Emitters() = default;
  /// `materials` and `textures` have the order of scene.materials and scene.textures.
  Emitters(const Scene& scene, std::span<const WhittedMaterial> materials, std::span<const DeviceTexture> textures,
           const ThreadPool& pool);

  /// Returns the emitter of an instance, or null if the instance is not an emissive mesh. Instances of the same shape and
  /// material share an emitter.
  const Emitter* of(std::size_t instance) const {
    return of_instance_[instance] < 0 ? nullptr : &emitters_[static_cast<std::size_t>(of_instance_[instance])];
  }

 private:
  std::vector<int> of_instance_;  ///< index into emitters_ for each instance; -1: not an emitter
  std::vector<Emitter> emitters_;
};

/// Returns the mean RGB of a map over a triangle of a mesh. Uses at most four lookups, at the mip level where the triangle is
/// two texels wide or high. Returns white if the mesh has no texture coordinates for the map.
Vec3f mean_over_triangle(const TextureMap& map, const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle);

}  // namespace lippmann
