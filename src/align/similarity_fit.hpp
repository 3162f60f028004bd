// Fits a rotation, scale and vertical shift to each image of a row of cameras, such that shared points are at equal heights.
//
// An ideal row of cameras sees a point at depth z at the same height in all images, at a horizontal position that depends on z.
// If q in image i and q' in image j show the same point, similarities S_i and S_j that align the images therefore satisfy
//   S_i(q).y = S_j(q').y + t (q.x - q'.x),
// where t is the slope of the line of the cameras relative to the rows. A similarity maps q to (a q.x - b q.y + x, b q.x + a
// q.y + y). Heights alone determine its a, b and y for every image, whatever the depths. Its x remains free. The equations are
// linear and solved for all images together, by robust least squares with small weights for outliers. Image `fixed` keeps the
// identity.
#pragma once

#include <cstddef>
#include <vector>

#include "align/similarity.hpp"

namespace lippmann {

/// Points that two images share, in pixels. Points with equal indices are the same scene point.
struct SharedPlaces {
  std::size_t first = 0, second = 0;  ///< indices of the images
  std::vector<Vec2d> in_first, in_second;
};

/// Removes points that do not fit the dominant rotation, scale and vertical shift between the two images: those whose height
/// differs by more than `tolerance` pixels. The dominant motion is found by RANSAC with a fixed sequence of samples of three
/// points.
void keep_consistent(SharedPlaces& shared, double tolerance);

struct FittedPictures {
  std::vector<Similarity> pictures;  ///< transforms that align the rows and keep the x of the centre: S(centre).x = centre.x
  double slope = 0.0;                ///< t, the slope of the line of the cameras
  std::vector<double> residuals;     ///< root mean square of the vertical differences that remain in each image, in pixels
};

/// Fits `count` images of size `size`. Shared points must connect each image with the image `fixed`, directly or through other
/// images.
FittedPictures fit_pictures(const std::vector<SharedPlaces>& shared, std::size_t count, std::size_t fixed, Vec2i size);

}  // namespace lippmann
