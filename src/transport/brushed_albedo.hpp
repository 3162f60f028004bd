// Directional albedo of single scattering at anisotropic GGX facets, as a table over angle, azimuth, roughness and anisotropy.
#pragma once

#include <memory>
#include <mutex>

#include "lippmann/core/math.hpp"

namespace lippmann {

class BrushedAlbedo {
 public:
  BrushedAlbedo();
  ~BrushedAlbedo();
  BrushedAlbedo(const BrushedAlbedo&) = delete;
  BrushedAlbedo& operator=(const BrushedAlbedo&) = delete;

  /// Returns the coefficients x and y of GgxAlbedo::single() for an anisotropic surface. v: view, unit length, v.z >= 0, with x
  /// along the rougher direction. alpha: roughness along y, in [0, 1]. The roughness along x is mix(alpha, 1, anisotropy^2), as
  /// in glTF.
  ///
  /// Thread-safe. The first call computes the table, which takes about 0.1 s.
  Vec2f single(Vec3f v, float alpha, float anisotropy) const;

 private:
  struct Table;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann
