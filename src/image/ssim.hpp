// Computes the structural similarity (SSIM) that image/metrics.hpp defines.
//
// The two images must have the same size. ssim() and contrast_structure() return NaN if a side is below 11 pixels.
#pragma once

#include "image/sample_plane.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns the luma 0.299 R + 0.587 G + 0.114 B of each pixel (BT.601), not rounded.
SamplePlane luma_601(const Image8& image);

double ssim(const Image8& reference, const Image8& test);
double ssim(const SamplePlane& reference, const SamplePlane& test);

/// Returns the mean of the contrast and structure factor (2 s_ab + C2) / (s_a^2 + s_b^2 + C2), with the covariance s_ab and the
/// variances s_a^2 and s_b^2 under the window.
double contrast_structure(const SamplePlane& reference, const SamplePlane& test);

}  // namespace lippmann
