// Resizes parts of images in linear light. Downsampling averages the covered area. Upsampling uses a Lanczos filter with 3
// lobes.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Output samples along one axis, in coordinates where input sample k covers the interval from k to k + 1. Output sample i
/// covers the interval from first + i step to first + (i + 1) step.
struct AxisSamples {
  double first = 0.0, step = 1.0;
  int count = 1;
  /// True: output samples whose centre is outside the input are black. False: the input's edge samples are repeated outside.
  bool black_outside = false;
};

/// Returns the resampled image in linear light, with 3 channels and across.count x down.count pixels. Output samples that
/// coincide with input samples have the same value. The result does not depend on the number of threads.
Image resampled_light(const Picture& picture, const AxisSamples& across, const AxisSamples& down, const ThreadPool& pool);

}  // namespace lippmann
