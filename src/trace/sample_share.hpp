// A subset of each pixel's samples, for frames that are traced in several passes.
#pragma once

namespace lippmann {

/// The samples first, first + step, first + 2 step and so on.
struct SampleShare {
  int first = 0, step = 1;

  bool is_first() const { return first == 0; }
  bool is_last() const { return first + 1 == step; }
  /// Converts the progress of this pass to that of all passes. Both are in [0, 1].
  double progress(double done) const { return (first + done) / step; }
};

}  // namespace lippmann
