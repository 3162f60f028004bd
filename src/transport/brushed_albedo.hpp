// Directional albedo of single scattering at anisotropic GGX facets, over angle, azimuth and both roughnesses. This is the
// anisotropic counterpart of the table in ggx_albedo.hpp.
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

  /// Returns GgxAlbedo::single for the view v (unit length, v.z >= 0, x along the rougher direction). alpha: along y, in [0,
  /// 1]. anisotropy: as in glTF, in [0, 1]; the alpha along x is mix(alpha, 1, anisotropy^2). The first call integrates the
  /// table (about 0.1 s), so scenes without such surfaces do not pay for it. Thread-safe.
  Vec2f single(Vec3f v, float alpha, float anisotropy) const;

 private:
  struct Table;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann
