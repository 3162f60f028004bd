#include "radiance/path_mix.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// Weights that are tried.
constexpr int kWeights = 32;

float excess(const MixedErrors& errors, const MixedErrors& may) {
  return std::max(errors.pixels / may.pixels, errors.blocks / may.blocks);
}

}  // namespace

MixedErrors errors_of(const PathMix& mix, const MixedErrors& cached, const MixedErrors& one_path) {
  if (mix.samples == 0) return cached;
  const float a = (1.0f - mix.weight) * (1.0f - mix.weight);
  const float b = mix.weight * mix.weight / static_cast<float>(mix.samples);
  return {a * cached.pixels + b * one_path.pixels, a * cached.blocks + b * one_path.blocks};
}

std::optional<PathMix> mix_for(const MixedErrors& cached, const MixedErrors& one_path, const MixedErrors& may, int most) {
  if (excess(cached, may) <= 1.0f) return PathMix{};
  for (int samples = 1; samples <= most; ++samples) {
    PathMix best{samples, 0.0f};
    for (int w = 1; w < kWeights; ++w) {
      const PathMix mix{samples, static_cast<float>(w) / kWeights};
      if (excess(errors_of(mix, cached, one_path), may) < excess(errors_of(best, cached, one_path), may)) best = mix;
    }
    if (excess(errors_of(best, cached, one_path), may) <= 1.0f) return best;
  }
  return std::nullopt;
}

PathMix scaled(const PathMix& mix, float factor, int most) {
  if (mix.samples == 0) return mix;
  const float wanted = factor * static_cast<float>(mix.samples);
  const int samples = std::clamp(static_cast<int>(factor > 1.0f ? std::ceil(wanted) : std::floor(wanted)), 0, most);
  if (samples == 0) return {};
  const float paths = mix.weight * static_cast<float>(samples), cached = (1.0f - mix.weight) * static_cast<float>(mix.samples);
  return {samples, paths / (paths + cached)};
}

}  // namespace lippmann
