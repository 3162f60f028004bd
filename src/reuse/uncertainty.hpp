// How far off the prediction of each pixel of an in-between frame may be, before anything of that frame has been traced.
//
// Uncertainty is counted in display codes, 0 ... 255. It puts pixels in order; what a given uncertainty means in squared error
// is not assumed but sampled (held_out.hpp).
//
//   uncertainty = a + A/2 + a'/2 + g/8 + g'/8
//   a   how much the two key frames' predictions of the pixel disagree. Lights, shadows, highlights and mirror images that move
//       otherwise than the surface disagree, as does most of what has landed beside an edge.
//   A   the largest a among the 8 neighbours in the same view, a' of the two pixels beside it, which belong to other views:
//       both keys may agree on what is wrong, but seldom all around.
//   g   contrast of the predicted picture: the largest difference to the 8 neighbours in the same view, g' to those two pixels.
//       A point lands up to half a step beside the pixel's centre, so that where colours change it is off by part of that.
// At least kOneKeyUncertainty where but one key frame has a point that lands, kMissedUncertainty where neither has. Measured
// and left out, because they added nothing: whether the two keys agree about the object; contrast two steps away; uncertainty
// further around; where held-out pixels near by turned out wrong.
//
// Codes are those of a square root for film that is encoded as sRGB (within 10 codes of it), else the values' own.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"
#include "reuse/splat.hpp"

namespace lippmann {

inline constexpr std::uint8_t kOneKeyUncertainty = 48, kMissedUncertainty = 96;

/// What one key frame alone says about an in-between frame; pixels onto which nothing of it landed have the other's colour.
struct Prediction {
  const Image& colors;
  const SplatBuffer& landed;
};

/// Keeps its working memory from frame to frame: used by one caller at a time.
class UncertaintyEstimator {
 public:
  /// `optics` must pass validate(). Its views' neighbours are taken to be whole pixels apart: nearly so where they are not.
  UncertaintyEstimator(const Optics& optics, Encoding encoding);

  /// Fills `uncertainty`, one entry per pixel. `film` is the prediction made of both.
  void estimate(const Prediction& previous, const Prediction& following, const Image& film, const ThreadPool& pool,
                std::vector<std::uint8_t>& uncertainty);

 private:
  /// One value per pixel, in rows with a margin of `across_` on either side.
  using Plane = std::vector<std::uint8_t>;

  void make_planes(const Prediction& previous, const Prediction& following, const Image& film, int row);

  int width_, height_, across_, down_;  ///< the last two: pixels from neighbour to neighbour of a view
  std::size_t stride_;                  ///< length of a plane's row, margins included
  bool linear_film_;
  Plane disagreement_, codes_[3];
};

}  // namespace lippmann
