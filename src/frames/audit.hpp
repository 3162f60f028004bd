// Estimates the error of a path-traced frame on held-out pixels.
//
// About one pixel in 500 is held out, which means that it is traced two more times with new random numbers. Let d be the sRGB
// code (0 to 1) of a held-out pixel in the frame, and a and b its codes in the two new images. a and b are independent of d and
// of each other. The expected value of (d - a)(d - b) is therefore the squared error of d, without the noise of a and b. The
// frame's squared error is the mean of (d - a)(d - b) over the held-out pixels. The estimate is only reported; it does not
// change the image.
#pragma once

#include <span>

#include "frames/frame.hpp"

namespace lippmann {

/// A mean squared error and the bounds of its 90 % interval, in squared codes (from 0 to 1). All three values are at least 0.
struct ErrorInterval {
  double mean = 0.0, low = 0.0, high = 0.0;
};

/// Returns the interval of the mean of `samples`, which are at least 2 independent estimates. The interval is symmetric in the
/// logarithm, because a few pixels cause most of the error. If the mean is not positive, `mean` and `low` are 0 and `high`
/// depends on the standard error alone.
ErrorInterval error_interval(std::span<const double> samples);

/// Sets the PSNR and its interval in `report`, and adds the rays and the time of the audit. `film` is the finished frame. The
/// audit changes its pixels temporarily and then restores them. The stage's device scene must be at the frame's time. Does
/// nothing for frames with motion blur, because their samples belong to several times.
void audit(Stage& stage, const Sampling& sampling, int frame, Image& film, const ThreadPool& pool, const Context& context,
           FrameReport& report);

}  // namespace lippmann
