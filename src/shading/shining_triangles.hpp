// The triangles of emissive meshes as lights, at their positions in the current frame.
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

  /// Returns the index of triangle `prim` of a record, or nothing if the record does not emit.
  std::optional<std::size_t> find(std::uint32_t record, std::uint32_t prim) const;

  /// Returns the projected area of a triangle along a unit direction.
  float seen_area(std::size_t triangle, Vec3f direction) const;

  /// Samples a point on a triangle by `u`. Returns nothing if the triangle sends no light to `from`.
  std::optional<LightSample> sample(std::size_t triangle, Vec3f from, Vec2f u) const;

 private:
  /// Aligned to a cache line, because triangles are accessed in random order.
  struct alignas(64) Triangle {
    Vec3f origin, edge_b, edge_c, normal;  ///< in world space; the normal has unit length, or is null for degenerate triangles
    float area;
    std::uint32_t record, prim;
    BodyFacing closed;  ///< facing of the triangle's mesh in world space; kNone: the mesh is not closed
  };

  void add(std::size_t record);
  /// Returns whether the triangle's own closed mesh hides the triangle from `from`. `direction` is the unit vector from `from`
  /// to the triangle.
  bool is_hidden(const Triangle& triangle, Vec3f from, Vec3f direction) const;
  Vec3f emission_at(const Triangle& triangle, Vec2f barycentric) const;

  LightSources sources_;
  std::vector<Triangle> triangles_;
  std::vector<int> first_;  ///< index of each record's first triangle; -1: the record does not emit
  /// For each record, the bounds of the mesh if it is closed and opaque. From outside these bounds, inner sides are invisible.
  /// Other records have infinite bounds. The vector is empty if no triangle emits.
  std::vector<Bounds3f> bodies_;
};

}  // namespace lippmann
