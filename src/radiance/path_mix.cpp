#include "radiance/path_mix.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lippmann {
namespace {

/// Weights that are tried.
constexpr int kWeights = 32;

float excess(const MixedErrors& errors, const MixedErrors& may) {
  return std::max(errors.pixels / may.pixels, errors.blocks / may.blocks);
}

/// The part of one path's error that is left with so many.
float part_left(int samples, float exponent) {
  const auto n = static_cast<float>(samples);
  float sum = 0.0f;
  for (int power = 1; power <= samples; power *= 2) {
    if ((samples & power) == 0) continue;
    const auto p = static_cast<float>(power);
    sum += p * p * std::pow(p, -exponent);
  }
  return sum / (n * n);
}

/// Half the largest power of two within: multiples of it up to twice that power are one power of two, or two that follow each
/// other.
int even_step(int samples) { return std::max(static_cast<int>(std::bit_floor(static_cast<unsigned>(samples))) / 2, 1); }

int evenly_spread(float wanted, bool more) {
  const int samples = static_cast<int>(more ? std::ceil(wanted) : std::floor(wanted));
  const int step = even_step(std::max(samples, 1));
  return (more ? samples + step - 1 : samples) / step * step;
}

}  // namespace

MixedErrors PathErrors::of(int samples) const {
  const float part = part_left(samples, exponent);
  return {part * one.pixels, part * one.blocks};
}

PathErrors PathErrors::with(const MixedErrors& found, int samples, float exponent) {
  const float part = part_left(samples, exponent);
  return {{found.pixels / part, found.blocks / part}, exponent};
}

MixedErrors errors_of(const PathMix& mix, const MixedErrors& cached, const PathErrors& paths) {
  if (mix.samples == 0) return cached;
  const float a = (1.0f - mix.weight) * (1.0f - mix.weight), b = mix.weight * mix.weight;
  const MixedErrors of_paths = paths.of(mix.samples);
  return {a * cached.pixels + b * of_paths.pixels, a * cached.blocks + b * of_paths.blocks};
}

std::optional<PathMix> mix_for(const MixedErrors& cached, const PathErrors& paths, const MixedErrors& may, int most) {
  if (excess(cached, may) <= 1.0f) return PathMix{};
  for (int samples = 1; samples <= most; ++samples) {
    PathMix best{samples, 0.0f};
    for (int w = 1; w < kWeights; ++w) {
      const PathMix mix{samples, static_cast<float>(w) / kWeights};
      if (excess(errors_of(mix, cached, paths), may) < excess(errors_of(best, cached, paths), may)) best = mix;
    }
    if (excess(errors_of(best, cached, paths), may) <= 1.0f) return best;
  }
  return std::nullopt;
}

PathMix scaled(const PathMix& mix, float factor, int most) {
  if (mix.samples == 0) return mix;
  const float wanted = factor * static_cast<float>(mix.samples);
  const int samples = std::clamp(evenly_spread(wanted, factor > 1.0f), 0, most);
  if (samples == 0) return {};
  const float paths = mix.weight * static_cast<float>(samples), cached = (1.0f - mix.weight) * static_cast<float>(mix.samples);
  return {samples, paths / (paths + cached)};
}

}  // namespace lippmann
