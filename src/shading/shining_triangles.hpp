// The triangles of emissive meshes as lights, at their current positions.
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

  /// Returns the triangles with their powers.
  LightGroup group() const;

  /// Returns the index of triangle `prim` of a record, or nothing if it does not emit.
  std::optional<std::size_t> find(std::uint32_t record, std::uint32_t prim) const;

  /// Returns the projected area of a triangle along a unit direction.
  float seen_area(std::size_t triangle, Vec3f direction) const;

  /// Samples a point on a triangle by `u`. Returns nothing if no light reaches `from`.
  std::optional<LightSample> sample(std::size_t triangle, Vec3f from, Vec2f u) const;

 private:
  /// One cache line, because triangles are accessed in random order.
  struct alignas(64) Triangle {
    Vec3f origin, edge_b, edge_c, normal;  ///< world space; the normal is unit length, or null for degenerate triangles
    float area;
    std::uint32_t record, prim;
    BodyFacing closed;  ///< facing in world space
  };

  void add(std::size_t record);
  /// Returns whether the triangle's own body hides its light along `direction` (unit, towards the triangle).
  bool is_hidden(const Triangle& triangle, Vec3f from, Vec3f direction) const;
  Vec3f emission_at(const Triangle& triangle, Vec2f barycentric) const;

  LightSources sources_;
  std::vector<Triangle> triangles_;
  std::vector<int> first_;  ///< index of each record's first triangle; -1 if it does not emit
  /// By record: the box of a closed, opaque mesh, whose inner sides are invisible from outside; an infinite box for all others.
  /// Empty if no triangle emits.
  std::vector<Bounds3f> bodies_;
};

}  // namespace lippmann
