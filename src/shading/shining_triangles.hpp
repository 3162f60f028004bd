#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shading/light_choice.hpp"
#include "shading/light_sample.hpp"
#include "shading/light_sources.hpp"

namespace lippmann {

class ShiningTriangles {
 public:
  explicit ShiningTriangles(const LightSources& sources);

  LightGroup group() const;

  std::optional<std::size_t> find(std::uint32_t record, std::uint32_t prim) const;

  float seen_area(std::size_t triangle, Vec3f direction) const;

  std::optional<LightSample> sample(std::size_t triangle, Vec3f from, Vec2f u) const;

 private:
  /// Aligned to a cache line, because triangles are accessed in random order.
  struct alignas(64) Triangle {
    Vec3f origin, edge_b, edge_c, normal;  ///< in world space; the normal has unit length, or is null for degenerate triangles
    float area;
    std::uint32_t record, prim;
    BodyFacing closed;  ///< facing of the triangle's mesh in world space
  };

  void add(std::size_t record);
  /// Returns whether the triangle's own closed mesh hides the triangle from `from`. `direction` is the unit vector from `from`
  /// to the triangle.
  bool is_hidden(const Triangle& triangle, Vec3f from, Vec3f direction) const;
  Vec3f emission_at(const Triangle& triangle, Vec2f barycentric) const;

  LightSources sources_;
  std::vector<Triangle> triangles_;
  std::vector<int> first_;
  /// For each record, the bounds of the mesh if it is closed and opaque, so that its inner sides are invisible from outside;
  /// otherwise infinite bounds. Empty if no triangle emits.
  std::vector<Bounds3f> bodies_;
};

}  // namespace lippmann
