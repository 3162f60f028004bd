// Finds how pictures of a row of cameras are turned, scaled and shifted up or down, from places that they share.
//
// A place at depth z lies at the same height in all pictures of an ideal row of cameras, at a horizontal position that depends
// on z. With q in picture i and q' in picture j, similarities S_i and S_j that align the pictures therefore satisfy
//   S_i(q).y = S_j(q').y + t (q.x - q'.x),
// where t is the slope at which the line of the cameras crosses the rows of the pictures. Heights alone determine a, b and y of
// every picture, whatever the depths; x remains free. The equations are linear. All pictures are solved together, by least
// squares with weights that give wrong matches little influence; picture `fixed` is the identity.
#pragma once

#include <cstddef>
#include <vector>

#include "align/similarity.hpp"

namespace lippmann {

/// Places that two pictures share, in pixels of the pictures: the same index, the same place.
struct SharedPlaces {
  std::size_t first = 0, second = 0;  ///< pictures
  std::vector<Vec2d> in_first, in_second;
};

/// Removes places that contradict the most common turn, scale and vertical shift between the two pictures by more than
/// `tolerance` pixels of height, found by a fixed sequence of samples of three places.
void keep_consistent(SharedPlaces& shared, double tolerance);

struct FittedPictures {
  std::vector<Similarity> pictures;  ///< x is 0 at the centre: S(centre).x = centre.x
  double slope = 0.0;                ///< t
  std::vector<double> residuals;     ///< root mean square of the remaining vertical differences of each picture, pixels
};

/// `size`: of the pictures. Each picture must be connected with picture `fixed` through shared places.
FittedPictures fit_pictures(const std::vector<SharedPlaces>& shared, std::size_t count, std::size_t fixed, Vec2i size);

}  // namespace lippmann
