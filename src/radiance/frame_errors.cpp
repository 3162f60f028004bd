#include "radiance/frame_errors.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// The past counts by this much of what it counted for the frame before.
constexpr float kRemembered = 0.6f;
/// Nothing at all, where it is so many standard deviations from the present: light has changed.
constexpr float kChanged = 2.5f;
/// An error is too large for sure by so many standard deviations; probably, where the mean with the past is, too, by so much:
/// it takes little to mend.
constexpr float kSure = 2.0f, kTolerated = 1.15f;

/// What ratios keep of the past where they are others, in frames.
constexpr float kKeptOfOther = 0.5f;
/// Ratios change by so much of themselves from frame to frame (standard deviation), which makes the past less certain: with it,
/// psnr_at_least_db holds for 95 % of the frames of hostile scenes (docs/decisions/0014-every-frame-is-measured.md).
constexpr float kRatioDrift = 0.15f;

bool is_other(float now, float uncertainty, float mean, float mean_uncertainty) {
  return std::abs(now - mean) > kChanged * std::hypot(uncertainty, mean_uncertainty);
}

Excess excess_of(float now, float uncertainty, float may, float mean, float mean_uncertainty, float mean_may) {
  if (now - kSure * uncertainty > may) return Excess::kSure;
  if (now > may && mean - kSure * mean_uncertainty > mean_may) return Excess::kSure;
  return now > may && mean > kTolerated * mean_may ? Excess::kProbable : Excess::kNone;
}

}  // namespace

void FrameErrors::add(const FrameError& now, const FrameError& may, float expected) {
  latest_ = now;
  pooled_.add({now.pixels, now.uncertainty}, expected);
  other_.add(now.other, expected);
  const bool changed = is_other(now.pixels, now.uncertainty, found_.pixels, found_.uncertainty);
  const float before = changed ? 0.0f : kRemembered * weight_;
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

void PooledError::add(const PixelError& now, float expected) {
  const float unit = expected > 0.0f ? expected : 1.0f;
  const PixelError ratio{now.squared / unit, now.uncertainty / unit};
  const float past_uncertainty = std::hypot(ratio_.uncertainty, kRatioDrift * ratio_.squared);
  const bool changed = is_other(ratio.squared, ratio.uncertainty, ratio_.squared, past_uncertainty);
  // A few pixels with large errors make a ratio seem another now and then, too: half a frame's worth of the past is kept.
  const float before = std::min(kRemembered * weight_, changed ? kKeptOfOther : kInfinity);
  weight_ = before + 1.0f;
  ratio_.squared += (ratio.squared - ratio_.squared) / weight_;
  ratio_.uncertainty = std::hypot(before * past_uncertainty, ratio.uncertainty) / weight_;
  of_latest_ = {unit * ratio_.squared, unit * ratio_.uncertainty};
}

}  // namespace lippmann
