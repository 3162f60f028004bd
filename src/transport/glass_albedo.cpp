#include "transport/glass_albedo.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "transport/bsdf.hpp"
#include "transport/microfacet.hpp"
#include "transport/sampler.hpp"
#include "transport/table_place.hpp"

namespace lippmann {
namespace {

constexpr float kLargestContrast = 0.5f;  // (n - 1) / (n + 1) for the index of refraction n = 3

/// Returns the albedo: the fraction of light that no further facet blocks, averaged over the facets visible from the viewing
/// direction.
float integrate(float cosine, float alpha, float eta) {
  constexpr int kPoints = 256;
  const Ggx ggx{alpha};
  const Vec3f view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  float sum = 0.0f;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Vec3f h = ggx.sample_visible(view, scrambled_sobol(i, 1u));
    const float fresnel = fresnel_dielectric(glm::dot(view, h), eta);
    const Vec3f reflected = mirrored(view, h), refracted = refracted_away(view, h, eta);
    if (reflected.z > 0.0f) sum += fresnel * ggx.masking(view, reflected) / ggx.masking(view);
    if (refracted.z < 0.0f) sum += (1.0f - fresnel) * ggx.masking(refracted);
  }
  return sum / kPoints;
}

/// The albedos of glass, indexed by [contrast][roughness][cosine]. The contrast is (n - 1) / (n + 1), where n is the index of
/// refraction.
class Table {
 public:
  Table(int contrasts, int cosines, bool entering) : contrasts_(contrasts), cosines_(cosines) {
    for (int k = 0; k < contrasts; ++k) {
      const float contrast = kLargestContrast * square(at(k, contrasts)), ior = (1.0f + contrast) / (1.0f - contrast);
      for (int r = 0; r < kRoughnesses; ++r)
        for (int c = 0; c < cosines; ++c)
          values_.push_back(integrate(std::max(at(c, cosines), 1e-3f), std::max(square(at(r, kRoughnesses)), kSmoothAlpha),
                                      entering ? ior : 1.0f / ior));
    }
  }

  float look_up(float cosine, float alpha, float ior) const {
    const TablePlace k(std::sqrt((ior - 1.0f) / (ior + 1.0f) / kLargestContrast), contrasts_);
    const TablePlace r(std::sqrt(alpha), kRoughnesses), c(cosine, cosines_);
    const auto row = [&](int contrast, int roughness) {
      const float* values = values_.data() + (contrast * kRoughnesses + roughness) * cosines_ + c.index;
      return glm::mix(values[0], values[1], c.share);
    };
    const auto page = [&](int contrast) { return glm::mix(row(contrast, r.index), row(contrast, r.index + 1), r.share); };
    return glm::mix(page(k.index), page(k.index + 1), k.share);
  }

 private:
  static constexpr int kRoughnesses = 16;
  static float at(int i, int size) { return static_cast<float>(i) / static_cast<float>(size - 1); }
  static float square(float x) { return x * x; }

  int contrasts_, cosines_;
  std::vector<float> values_;
};

}  // namespace

/// For rays that leave the glass, total reflection causes sharp edges in the albedo, which need a finer table.
struct GlassAlbedo::Tables {
  Table entered{6, 16, true}, left{12, 24, false};
};

GlassAlbedo::GlassAlbedo() = default;
GlassAlbedo::~GlassAlbedo() = default;

float GlassAlbedo::single(float cosine, float alpha, float eta) const {
  std::call_once(once_, [&] { tables_ = std::make_unique<const Tables>(); });
  return eta >= 1.0f ? tables_->entered.look_up(cosine, alpha, eta) : tables_->left.look_up(cosine, alpha, 1.0f / eta);
}

}  // namespace lippmann
