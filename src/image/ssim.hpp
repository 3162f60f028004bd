// Structural similarity of two images; defined in image/metrics.hpp.
//
// The two images must have the same size. All functions return NaN if a side is below 11 pixels.
#pragma once

#include "image/sample_plane.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann {

/// Returns 0.299 R + 0.587 G + 0.114 B of codes (BT.601), not rounded.
SamplePlane luma_601(const Image8& image);

double ssim(const Image8& reference, const Image8& test);
double ssim(const SamplePlane& reference, const SamplePlane& test);

/// Returns the mean of SSIM without its luminance term: (2 s_ab + C2) / (s_a^2 + s_b^2 + C2).
double contrast_structure(const SamplePlane& reference, const SamplePlane& test);

}  // namespace lippmann
