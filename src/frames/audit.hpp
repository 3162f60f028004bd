// Estimates the error of a path-traced frame on held-out pixels.
//
// About one pixel in 500 is traced again, twice, with random numbers of its own. With d the code (sRGB, 0 to 1) of the frame's
// pixel, and a and b those of the two pictures, which are independent of d and of each other, the expected value of
// (d - a)(d - b) is the squared error of d: the noise of a and b does not add to it. The frame's squared error is the mean over
// the held-out pixels. The estimate is reported; no picture depends on it.
#pragma once

#include <span>

#include "frames/frame.hpp"

namespace lippmann {

/// A mean squared error and the bounds of its 90 % interval, each >= 0; codes from 0 to 1.
struct ErrorInterval {
  double mean = 0.0, low = 0.0, high = 0.0;
};

/// The interval of the mean of which `samples` (2 or more) are independent estimates. It lies symmetrically about the
/// logarithm of their mean, because a few pixels make most of the error; where the mean is not positive, low is 0 and high
/// follows from the standard error alone.
ErrorInterval error_interval(std::span<const double> samples);

/// Fills the PSNR and its interval in `report`, and adds the rays and the time. `film` is the finished frame; the device scene
/// is at the frame's moment. Does nothing for frames with motion blur, whose samples belong to several moments.
void audit(Stage& stage, const Sampling& sampling, int frame, Image& film, const ThreadPool& pool, const Context& context,
           FrameReport& report);

}  // namespace lippmann
