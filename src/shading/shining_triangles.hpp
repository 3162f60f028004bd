// The triangles of meshes that shine, as lights: where they are at this moment, and what of their light reaches a point.
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

  /// The triangles with their powers.
  LightGroup group() const;

  /// The number of the triangle `prim` of a record; none if it does not shine.
  std::optional<std::size_t> find(std::uint32_t record, std::uint32_t prim) const;

  /// The area of a triangle as it is seen along a unit direction.
  float seen_area(std::size_t triangle, Vec3f direction) const;

  /// Light from a point on a triangle, chosen by `u`. None where none reaches `from`.
  std::optional<LightSample> sample(std::size_t triangle, Vec3f from, Vec2f u) const;

 private:
  /// A line of a cache: triangles are asked for in any order.
  struct alignas(64) Triangle {
    Vec3f origin, edge_b, edge_c, normal;  ///< world space; normal unit, or null for triangles without area
    float area;
    std::uint32_t record, prim;
    BodyFacing closed;  ///< in world space
  };

  void add(std::size_t record);
  /// Whether light that a triangle sends along `direction` (unit, towards it) would have to come through its own body.
  bool is_hidden(const Triangle& triangle, Vec3f from, Vec3f direction) const;
  Vec3f emission_at(const Triangle& triangle, Vec2f barycentric) const;

  LightSources sources_;
  std::vector<Triangle> triangles_;
  std::vector<int> first_;  ///< per record, of its triangles; -1: does not shine
  /// By record: the box around a mesh that is closed and opaque, whose triangles' inner sides nobody sees from outside; an
  /// endless one around all others. Empty: no triangle shines.
  std::vector<Bounds3f> bodies_;
};

}  // namespace lippmann
