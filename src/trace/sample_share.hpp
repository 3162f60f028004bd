// Some of the samples of every pixel, where not all are traced at once.
#pragma once

namespace lippmann {

/// Samples first, first + step, ...: one of `step` shares, which are traced one after the other.
struct SampleShare {
  int first = 0, step = 1;

  bool is_first() const { return first == 0; }
  bool is_last() const { return first + 1 == step; }
  /// Of all shares' work, once this share of this one's is done.
  double progress(double done) const { return (first + done) / step; }
};

}  // namespace lippmann
