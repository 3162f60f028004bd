// How much light one scattering at anisotropic GGX facets sends back, over angle, azimuth and both roughnesses:
// ggx_albedo.hpp's table, for gloss that is rougher one way.
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

  /// As GgxAlbedo::single, of the view v (unit, v.z >= 0, x along the rougher way). alpha: across; anisotropy: as glTF has it,
  /// from alpha to 1 along x with its square; both in [0, 1]. The first call, from whichever thread, integrates the table: some
  /// 0.1 s, which scenes without such surfaces need not wait for.
  Vec2f single(Vec3f v, float alpha, float anisotropy) const;

 private:
  struct Table;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Table> table_;
};

}  // namespace lippmann
