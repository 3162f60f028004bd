// Estimates the error of each predicted pixel of an in-between frame before any part of the frame is traced.
//
// Uncertainty is in display codes, 0 ... 255. It only ranks pixels; the squared error of a given uncertainty is measured by
// samples (held_out.hpp).
//
//   uncertainty = a + A/2 + a'/2 + g/8 + g'/8
//   a   disagreement of the two key frames' predictions of the pixel. Lights, shadows, highlights and mirror images that move
//       differently from the surface disagree, as do most points that land beside an edge.
//   A   the largest a among the 8 neighbours in the same view; a' is that of the two adjacent pixels, which belong to other
//       views. Both keys may agree on a wrong colour, but rarely in all neighbours.
//   g   contrast of the predicted image: the largest difference to the 8 neighbours in the same view; g' is that to the two
//       adjacent pixels. A point lands up to half a step beside the pixel's centre, so its colour is wrong by part of the
//       contrast.
// The minimum is kOneKeyUncertainty if only one key frame has a landed point, and kMissedUncertainty if neither has.
//
// Codes of film that will be encoded as sRGB are approximated by square roots, with an error of up to 10 codes. Otherwise the
// codes are the values themselves.
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

/// The prediction of an in-between frame from one key frame. Pixels on which none of its points land have the colour of the
/// other prediction.
struct Prediction {
  const Image& colors;
  const SplatBuffer& landed;
};

/// Estimates uncertainty and reuses memory from frame to frame. Not thread-safe.
class UncertaintyEstimator {
 public:
  /// `optics` must pass validate(). Distances between neighbours of a view are rounded to whole pixels.
  UncertaintyEstimator(const Optics& optics, Encoding encoding);

  /// Fills `uncertainty`, one entry per pixel. `film` is the prediction from both keys.
  void estimate(const Prediction& previous, const Prediction& following, const Image& film, const ThreadPool& pool,
                std::vector<std::uint8_t>& uncertainty);

 private:
  /// One value per pixel, in rows with a margin of `across_` on both sides.
  using Plane = std::vector<std::uint8_t>;

  void make_planes(const Prediction& previous, const Prediction& following, const Image& film, int row);

  int width_, height_, across_, down_;  ///< across_, down_: pixels between neighbours of a view
  std::size_t stride_;                  ///< length of a plane's row, including margins
  bool linear_film_;
  Plane disagreement_, codes_[3];
};

}  // namespace lippmann
