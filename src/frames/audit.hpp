// Estimates the error of a path-traced frame on held-out pixels.
//
// About one pixel in 500 is held out, which means that it is traced two more times with new random numbers. Let d be the sRGB
// code (0 to 1) of a held-out pixel in the frame, and a and b its codes in the two new images. Since a, b and d are
// independent, the expected value of (d - a)(d - b) is the squared error of d. The frame's squared error is the mean of (d -
// a)(d - b) over the held-out pixels.
#pragma once

#include <span>

#include "frames/frame.hpp"

namespace lippmann {

struct ErrorInterval {
  double mean = 0.0, low = 0.0, high = 0.0;
};

/// Returns the interval of the mean of at least 2 independent estimates. The interval is symmetric on a logarithmic scale,
/// because a few pixels cause most of the error. If the mean is not positive, `mean` and `low` are 0.
ErrorInterval error_interval(std::span<const double> samples);

/// Adds the PSNR, its interval, and the rays and time of the audit to `report`. `film` is the finished frame, whose pixels
/// change only temporarily. The stage's device scene must be at the frame's time. Does nothing for frames with motion blur.
void audit(Stage& stage, const Sampling& sampling, int frame, Image& film, const ThreadPool& pool, const Context& context,
           FrameReport& report);

}  // namespace lippmann
