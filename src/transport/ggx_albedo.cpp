#include "transport/ggx_albedo.hpp"

#include "transport/microfacet.hpp"
#include "transport/sampler.hpp"
#include "transport/table_place.hpp"

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
  for (std::size_t r = 0; r < kSize; ++r) {
    const float roughness = kStep * static_cast<float>(r), alpha = std::max(roughness * roughness, kSmoothAlpha);
    for (std::size_t c = 0; c < kSize; ++c) single_[r][c] = integrate(std::max(kStep * static_cast<float>(c), 1e-3f), alpha);
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
    mean_[r] = sum * (2.0f / kPoints);
  }
}

Vec3f GgxAlbedo::single(float cosine, float alpha) const {
  const TablePlace r(std::sqrt(alpha), kSize), c(cosine, kSize);
  const auto row = [&](std::size_t index) { return glm::mix(single_[index][c.index], single_[index][c.index + 1], c.share); };
  return {glm::mix(row(r.index), row(r.index + 1), r.share), edge_of_later_facets(cosine, alpha)};
}

Vec3f GgxAlbedo::mean(float alpha, Vec3f f0, Vec3f f90) const {
  const TablePlace r(std::sqrt(alpha), kSize);
  const Vec4f m = glm::mix(mean_[r.index], mean_[r.index + 1], r.share);
  const float edge = edge_of_later_facets(0.65f, alpha);  // where most of it is lost
  return are_grey(f0, f90) ? Vec3f(mean_of(m, edge, f0.x, f90.x)) : mean_of(m, edge, f0, f90);
}

}  // namespace lippmann
