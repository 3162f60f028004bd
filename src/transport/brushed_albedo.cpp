#include "transport/brushed_albedo.hpp"

#include <vector>

#include "transport/bsdf.hpp"
#include "transport/microfacet.hpp"
#include "transport/sampler.hpp"
#include "transport/table_place.hpp"

namespace lippmann {
namespace {

Vec2f integrate(Vec3f view, Vec2f alpha) {
  constexpr int kPoints = 128;
  const AnisotropicGgx ggx{glm::max(alpha, Vec2f(kSmoothAlpha))};
  Vec2f sum(0.0f);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Vec3f h = ggx.sample_visible(view, scrambled_sobol(i, 1u)), out = mirrored(view, h);
    if (!(out.z > 0.0f)) continue;
    const float weight = ggx.masking(view, out) / ggx.masking(view), edge = schlick_weight(glm::dot(view, h));
    sum += weight * Vec2f(1.0f - edge, edge);
  }
  return sum / static_cast<float>(kPoints);
}

}  // namespace

/// `values` is indexed by [roughness][anisotropy][cosine][azimuth]. The samples are evenly spaced in
/// sqrt(roughness), sqrt(cosine) and cos^2(azimuth).
struct BrushedAlbedo::Table {
  static constexpr int kRoughnesses = 10, kAnisotropies = 10, kCosines = 16, kAzimuths = 7;
  std::vector<Vec2f> values;

  Table() {
    const auto at = [](int i, int size) { return static_cast<float>(i) / static_cast<float>(size - 1); };
    for (int r = 0; r < kRoughnesses; ++r)
      for (int a = 0; a < kAnisotropies; ++a)
        for (int c = 0; c < kCosines; ++c)
          for (int z = 0; z < kAzimuths; ++z) {
            const float across = squared(at(r, kRoughnesses)), along = glm::mix(across, 1.0f, squared(at(a, kAnisotropies)));
            const float cosine = std::max(squared(at(c, kCosines)), 1e-3f), sine = std::sqrt(1.0f - squared(cosine));
            const float of_x = at(z, kAzimuths);
            values.push_back(integrate({sine * std::sqrt(of_x), sine * std::sqrt(1.0f - of_x), cosine}, {along, across}));
          }
  }

  Vec2f look_up(const TablePlace (&places)[4]) const {
    constexpr std::size_t kSizes[4] = {kRoughnesses, kAnisotropies, kCosines, kAzimuths};
    Vec2f sum(0.0f);
    for (unsigned corner = 0; corner < 16; ++corner) {
      std::size_t index = 0;
      float share = 1.0f;
      for (unsigned d = 0; d < 4; ++d) {
        const bool next = (corner >> d & 1u) != 0;
        index = index * kSizes[d] + static_cast<std::size_t>(places[d].index) + (next ? 1 : 0);
        share *= next ? places[d].share : 1.0f - places[d].share;
      }
      sum += share * values[index];
    }
    return sum;
  }
};

BrushedAlbedo::BrushedAlbedo() = default;
BrushedAlbedo::~BrushedAlbedo() = default;

Vec2f BrushedAlbedo::single(Vec3f v, float alpha, float anisotropy) const {
  std::call_once(once_, [&] { table_ = std::make_unique<const Table>(); });
  const float across = v.x * v.x + v.y * v.y;
  const TablePlace places[4] = {{std::sqrt(alpha), Table::kRoughnesses},
                                {anisotropy, Table::kAnisotropies},
                                {std::sqrt(v.z), Table::kCosines},
                                {across > 0.0f ? v.x * v.x / across : 0.0f, Table::kAzimuths}};
  return table_->look_up(places);
}

}  // namespace lippmann
