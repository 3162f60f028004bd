// Resizes parts of images in linear light: by area for downsampling, by a Lanczos filter with 3 lobes for upsampling.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// Output samples along one axis: sample i covers first + i step ... first + (i + 1) step, in coordinates where input sample k
/// covers k ... k + 1.
struct AxisSamples {
  double first = 0.0, step = 1.0;
  int count = 1;
  /// True: output samples centred outside the input are black. False: the input's edge is repeated.
  bool black_outside = false;
};

/// Returns the resampled image: linear light, 3 channels, across.count x down.count pixels. Output samples that coincide with
/// input samples keep their value. The result does not depend on the number of threads.
Image resampled_light(const Picture& picture, const AxisSamples& across, const AxisSamples& down, const ThreadPool& pool);

}  // namespace lippmann
