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
  BodyFacing closed = BodyFacing::kNone;
  float luminance = 0.0f;
  std::vector<float> by_triangle;  ///< mean luminance over each triangle, > 0; empty if the material has no emissive texture
  float of(std::size_t triangle) const { return by_triangle.empty() ? luminance : by_triangle[triangle]; }
};

class Emitters {
 public:
  Emitters() = default;
  Emitters(const Scene& scene, std::span<const WhittedMaterial> materials, std::span<const DeviceTexture> textures,
           const ThreadPool& pool);

  const Emitter* of(std::size_t instance) const {
    return of_instance_[instance] < 0 ? nullptr : &emitters_[static_cast<std::size_t>(of_instance_[instance])];
  }

 private:
  std::vector<int> of_instance_;
  std::vector<Emitter> emitters_;
};

Vec3f mean_over_triangle(const TextureMap& map, const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle);

}  // namespace lippmann
