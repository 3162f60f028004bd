#include "transport/sheen.hpp"

#include <algorithm>

#include "transport/sampler.hpp"
#include "transport/table_place.hpp"

namespace lippmann {
namespace {

/// Floats are too imprecise for lower roughness.
constexpr float kLeastRoughness = 0.1f;

float alpha_of(float roughness) { return squared(std::max(roughness, kLeastRoughness)); }

/// The exponent of the shadowing as a function of the cosine, interpolated between the fits for alpha = 1 and alpha = 0
/// (section 3 and table 1 of the paper in sheen.hpp).
class Shadowing {
 public:
  explicit Shadowing(float alpha) {
    const float share = squared(1.0f - alpha);
    const auto at = [&](float rough, float smooth) { return rough + share * (smooth - rough); };
    a_ = at(21.5473f, 25.3245f), b_ = at(3.82987f, 3.32435f), c_ = at(0.19823f, 0.16801f);
    d_ = at(-1.97760f, -1.27393f), e_ = at(-4.32054f, -4.85967f);
  }
  float lambda(float cosine) const {
    return std::exp(cosine < 0.5f ? curve(cosine) : 2.0f * curve(0.5f) - curve(1.0f - cosine));
  }

 private:
  float curve(float x) const { return a_ / (1.0f + b_ * std::pow(x, c_)) + d_ * x + e_; }

  float a_, b_, c_, d_, e_;
};

}  // namespace

float sheen_f(Vec3f view, Vec3f light, float roughness) {
  const float alpha = alpha_of(roughness);
  const Vec3f h = glm::normalize(view + light);
  const float sine = std::sqrt(std::max(0.0f, 1.0f - h.z * h.z));
  const float distribution = (2.0f + 1.0f / alpha) * std::pow(sine, 1.0f / alpha) / (2.0f * kPi);
  const Shadowing shadowing(alpha);
  return distribution / ((1.0f + shadowing.lambda(view.z) + shadowing.lambda(light.z)) * 4.0f * view.z * light.z);
}

SheenAlbedo::SheenAlbedo() = default;
SheenAlbedo::~SheenAlbedo() = default;

SheenAlbedo::Table SheenAlbedo::integrated() {
  constexpr std::uint32_t kPoints = 512;
  constexpr float kStep = 1.0f / (kSize - 1);
  Table table;
  for (std::size_t r = 0; r < kSize; ++r)
    for (std::size_t c = 0; c < kSize; ++c) {
      const float cosine = std::max(kStep * static_cast<float>(c), 1e-3f);
      const Vec3f view(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
      float sum = 0.0f;
      for (std::uint32_t i = 0; i < kPoints; ++i) {
        const Vec2f u = scrambled_sobol(i, 1u);
        const float z = std::max(u.x, 1e-4f), radius = std::sqrt(1.0f - z * z), angle = 2.0f * kPi * u.y;
        sum += z * sheen_f(view, {radius * std::cos(angle), radius * std::sin(angle), z}, kStep * static_cast<float>(r));
      }
      table[r][c] = std::min(1.0f, sum * (2.0f * kPi / kPoints));
    }
  return table;
}

float SheenAlbedo::operator()(float cosine, float roughness) const {
  std::call_once(once_, [&] { table_ = std::make_unique<const Table>(integrated()); });
  const TablePlace r(roughness, kSize), c(cosine, kSize);
  const auto row = [&](int index) {
    const float* values = (*table_)[static_cast<std::size_t>(index)].data() + c.index;
    return values[0] + c.share * (values[1] - values[0]);
  };
  return row(r.index) + r.share * (row(r.index + 1) - row(r.index));
}

}  // namespace lippmann
