#include "radiance/frame_errors.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// The past counts by this much of what it counted for the frame before.
constexpr float kRemembered = 0.6f;
/// Nothing at all, where it is so many standard deviations from the present: light has changed.
constexpr float kChanged = 2.5f;
/// An error is too large for sure by so many standard deviations; probably, where the mean with the past is, too.
constexpr float kSure = 2.0f;

/// Ratios change by at least so much of themselves from frame to frame (standard deviation), which makes the past less certain;
/// by how much more, those of a history tell, its latest ones most.
constexpr float kLeastDrift = 0.2f, kDriftRemembered = 0.5f;
/// No ratio is known better than to so much of itself.
constexpr float kLeastDeviation = 0.02f;

/// Errors of means change by so much of themselves from frame to frame, or of what they may be if they are less than the second
/// part of it.
constexpr float kMeansDrift = 0.2f, kLeastMeans = 0.25f;
/// The variance of what is measured is told by so many frames.
constexpr float kNoiseFrames = 8.0f;

bool is_other(float now, float uncertainty, float mean, float mean_uncertainty) {
  return std::abs(now - mean) > kChanged * std::hypot(uncertainty, mean_uncertainty);
}

Excess excess_of(float now, float uncertainty, float may, float mean, float mean_uncertainty, float mean_may) {
  if (now - kSure * uncertainty > may) return Excess::kSure;
  if (now > may && mean - kSure * mean_uncertainty > mean_may) return Excess::kSure;
  return now > may && mean > mean_may ? Excess::kProbable : Excess::kNone;
}

}  // namespace

void FrameErrors::add(const FrameError& now, const FrameError& may, float expected) {
  latest_ = now;
  pooled_.add({now.pixels, now.uncertainty}, expected);
  other_.add(now.other, expected);
  const bool changed = is_other(now.pixels, now.uncertainty, found_.pixels, found_.uncertainty);
  const float before = changed ? 0.0f : kRemembered * weight_;
  if (changed && weight_ > 0.0f) means_.forget();
  weight_ = before + 1.0f;
  const auto pool = [&](float& mean, float value) { mean += (value - mean) / weight_; };
  pool(found_.pixels, now.pixels), pool(allowed_.pixels, may.pixels);
  found_.uncertainty = std::hypot(before * found_.uncertainty, now.uncertainty) / weight_;
  means_.add(now.blocks / may.blocks, now.block_uncertainty / may.blocks);
  allowed_.blocks = may.blocks;
  found_.blocks = means_.ratio() * may.blocks, found_.block_uncertainty = means_.deviation() * may.blocks;
  pixels_ = excess_of(now.pixels, now.uncertainty, may.pixels, found_.pixels, found_.uncertainty, allowed_.pixels);
  blocks_ = excess_of(now.blocks, now.block_uncertainty, may.blocks, found_.blocks, found_.block_uncertainty, allowed_.blocks);
}

void FrameErrors::expect_means(const PixelError& blocks, float may) {
  means_.expect(blocks.squared / may, blocks.uncertainty / may);
}

void PooledMeans::expect(float ratio, float deviation) { ratio_ = ratio, variance_ = squared(deviation), knows_ = true; }

/// As PooledError, but for errors themselves: those that are measured may be below 0. Their own deviations say less of how
/// certain they are than the mean of these over frames: frames that were lucky have small ones, and would count for more.
void PooledMeans::add(float ratio, float deviation) {
  measured_ = std::min(measured_ + 1.0f, kNoiseFrames);
  noise_ += (squared(deviation) - noise_) / measured_;
  const float past = variance_ + squared(kMeansDrift * std::max(ratio_, kLeastMeans));
  if (!knows_ || is_other(ratio, std::sqrt(noise_), ratio_, std::sqrt(past))) {
    expect(ratio, std::sqrt(noise_));
    return;
  }
  const float of_latest = past / std::max(past + noise_, 1e-20f);
  ratio_ += of_latest * (ratio - ratio_);
  variance_ = (1.0f - of_latest) * past;
}

float PooledMeans::deviation() const { return std::sqrt(variance_); }

/// The filter of R. E. Kalman, "A New Approach to Linear Filtering and Prediction Problems", 1960, on a logarithm that drifts
/// by an amount that is not known beforehand: it is what successive logarithms differ by beyond their deviations.
void PooledError::add(const PixelError& now, float expected) {
  const float unit = expected > 0.0f ? expected : 1.0f;
  const float log_ratio = std::log(std::max(now.squared / unit, 1e-12f));
  const float deviation = std::max(now.uncertainty / std::max(now.squared, 1e-12f), kLeastDeviation);
  if (weight_ == 0.0f)
    log_ratio_ = log_ratio, variance_ = deviation * deviation, weight_ = 1.0f;
  else
    go_on(log_ratio, deviation * deviation);
  const float squared = unit * std::exp(log_ratio_);
  of_latest_ = {squared, squared * std::sqrt(variance_)};
}

void PooledError::go_on(float log_ratio, float variance) {
  const float difference = log_ratio - log_ratio_;
  weight_ = kDriftRemembered * weight_ + 1.0f;
  const float drift = std::max(difference * difference - variance - variance_, 0.0f);
  drift_ = std::max(drift_ + (drift - drift_) / weight_, kLeastDrift * kLeastDrift);
  const float past = variance_ + drift_;
  log_ratio_ += difference * past / (past + variance);
  variance_ = past * variance / (past + variance);
}

}  // namespace lippmann
