// Parts of pictures in another size, in linear light: by area where samples get larger, by Lanczos (3 lobes) where they get
// smaller.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {

/// New samples along one axis: sample i covers first + i step ... first + (i + 1) step of the old ones, which cover i ... i
/// + 1.
struct AxisSamples {
  double first = 0.0, step = 1.0;
  int count = 1;
  bool black_outside = false;  ///< samples whose centre lies outside are black; else the edge continues
};

/// Linear light of 3 channels, across.count x down.count. Old samples that are met exactly keep their value. The same for any
/// number of threads.
Image resampled_light(const Picture& picture, const AxisSamples& across, const AxisSamples& down, const ThreadPool& pool);

}  // namespace lippmann
