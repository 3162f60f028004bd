#include "transport/ggx_albedo.hpp"

#include "transport/microfacet.hpp"
#include "transport/sampler.hpp"

namespace lippmann {
namespace {

Vec2f integrate(float cosine, float alpha) {
  constexpr int kPoints = 512;
  const Ggx ggx{alpha};
  const Vec3f view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
  Vec2f sum(0.0f);
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const Vec3f h = ggx.sample_visible(view, scrambled_sobol(i, 1u));
    const Vec3f out = 2.0f * glm::dot(view, h) * h - view;
    if (!(out.z > 0.0f)) continue;
    const float weight = ggx.masking(view, out) / ggx.masking(view), edge = schlick_weight(glm::dot(view, h));
    sum += weight * Vec2f(1.0f - edge, edge);
  }
  return sum / static_cast<float>(kPoints);
}

}  // namespace

GgxAlbedo::GgxAlbedo() {
  constexpr float kStep = 1.0f / (kSize - 1);
  for (std::size_t at = 0; at < std::size(single_f0_); ++at) {
    const float roughness = kStep * static_cast<float>(at / kSize), cosine = kStep * static_cast<float>(at % kSize);
    const Vec2f single = integrate(std::max(cosine, 1e-3f), std::max(roughness * roughness, kSmoothAlpha));
    single_f0_[at] = single.x, single_f90_[at] = single.y;
  }
  for (std::size_t r = 0; r < kSize; ++r) {
    const float roughness = kStep * static_cast<float>(r);
    constexpr int kPoints = 256;
    Vec4f sum(0.0f);
    for (int i = 0; i < kPoints; ++i) {
      const float cosine = (static_cast<float>(i) + 0.5f) / kPoints;
      const Vec2f s(single(cosine, roughness * roughness));
      const float lost = (1.0f - s.x - s.y) / (s.x + s.y);
      sum += cosine * Vec4f(s.x, s.y, lost * s.x, lost * s.y);
    }
    for (int k = 0; k < 4; ++k) mean_[static_cast<std::size_t>(k)][r] = sum[k] * (2.0f / kPoints);
  }
}

}  // namespace lippmann
