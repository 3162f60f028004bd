// Fits a rotation, scale and vertical shift to each image of a row of cameras, such that shared points are at equal heights.
//
// If q in image i and q' in image j show the same point, similarities S_i and S_j that align the images satisfy
//   S_i(q).y = S_j(q').y + t (q.x - q'.x),
// where t is the slope of the line of the cameras relative to the rows. A similarity maps q to (a q.x - b q.y + x, b q.x + a
// q.y + y). Heights alone determine its a, b and y for every image. Its x remains free. The equations are linear and solved for
// all images together, by robust least squares with small weights for outliers. Image `fixed` keeps the identity.
#pragma once

#include <cstddef>
#include <vector>

#include "align/similarity.hpp"

namespace lippmann {

/// Points that two images share, in pixels. Points with equal indices are the same scene point.
struct SharedPlaces {
  std::size_t first = 0, second = 0;
  std::vector<Vec2d> in_first, in_second;
};

/// Removes points whose height differs by more than `tolerance` pixels from the dominant motion between the two images
/// (rotation, scale and vertical shift). RANSAC finds this motion, with a fixed sequence of samples.
void keep_consistent(SharedPlaces& shared, double tolerance);

struct FittedPictures {
  std::vector<Similarity> pictures;
  double slope = 0.0;
  std::vector<double> residuals;  ///< root mean square of the vertical differences that remain in each image, in pixels
};

/// Fits `count` images of size `size`. Shared points must connect each image with the image `fixed`, directly or through other
/// images.
FittedPictures fit_pictures(const std::vector<SharedPlaces>& shared, std::size_t count, std::size_t fixed, Vec2i size);

}  // namespace lippmann
