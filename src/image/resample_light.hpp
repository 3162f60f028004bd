// Resizes parts of images in linear light. Downsampling averages the covered area; upsampling uses a Lanczos filter with 3
// lobes.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Output sample i covers the interval from first + i * step to first + (i + 1) * step. Input sample k covers the interval from
/// k to k + 1.
struct AxisSamples {
  double first = 0.0, step = 1.0;
  int count = 1;
  /// True: output samples whose centre is outside the input are black. False: the input's edge samples are repeated.
  bool black_outside = false;
};

/// Returns 3 channels in linear light and across.count x down.count pixels. Output samples that coincide with input samples
/// have the same value.
Image resampled_light(const Picture& picture, const AxisSamples& across, const AxisSamples& down, const ThreadPool& pool);

}  // namespace lippmann
