#include "trace/frame_errors.hpp"

#include <cmath>

namespace lippmann {
namespace {

/// The past counts by this much of what it counted for the frame before.
constexpr float kRemembered = 0.6f;
/// An error is too large for sure by so many standard deviations; probably, where the past says so, too, by so much.
constexpr float kSure = 1.65f, kTolerated = 1.15f;

Excess excess_of(float now, float uncertainty, float may, float mean, float mean_uncertainty, float mean_may) {
  if (now - kSure * uncertainty > may) return Excess::kSure;
  if (now > may && mean - kSure * mean_uncertainty > mean_may) return Excess::kSure;
  return now > may && mean - mean_uncertainty > kTolerated * mean_may ? Excess::kProbable : Excess::kNone;
}

}  // namespace

void FrameErrors::add(const FrameError& now, const FrameError& may) {
  const float before = kRemembered * weight_;
  weight_ = before + 1.0f;
  const auto pool = [&](float& mean, float value) { mean += (value - mean) / weight_; };
  const auto pool_deviation = [&](float& mean, float value) {
    mean = std::sqrt(before * before * mean * mean + value * value) / weight_;
  };
  pool(found_.pixels, now.pixels), pool(found_.blocks, now.blocks);
  pool(allowed_.pixels, may.pixels), pool(allowed_.blocks, may.blocks);
  pool_deviation(found_.uncertainty, now.uncertainty), pool_deviation(found_.block_uncertainty, now.block_uncertainty);
  pixels_ = excess_of(now.pixels, now.uncertainty, may.pixels, found_.pixels, found_.uncertainty, allowed_.pixels);
  blocks_ = excess_of(now.blocks, now.block_uncertainty, may.blocks, found_.blocks, found_.block_uncertainty, allowed_.blocks);
}

}  // namespace lippmann
