// Estimates the error of each predicted pixel of an in-between frame before any part of the frame is traced.
//
// Uncertainty is in display codes, 0 ... 255. It only ranks pixels; held_out.hpp measures the actual errors.
//
//   uncertainty = a + A/2 + a'/2 + g/8 + g'/8
//   a   Difference between the predictions of the pixel from the two key frames. Predictions differ for lights, shadows,
//       highlights and mirror images that do not move with the surface, and for most points that land beside an edge.
//   A   Largest a of the 8 neighbours in the same view. Both key frames may predict the same wrong colour at a pixel, but
//       rarely at all its neighbours.
//   a'  Largest a of the two adjacent pixels, which belong to other views.
//   g   Contrast of the predicted image: the largest difference between the pixel and its 8 neighbours in the same view.
//       A point may land up to half way between two of these pixels, so its colour is wrong by part of the contrast.
//   g'  Largest difference between the pixel and the two adjacent pixels.
//
// If points of only one key frame land on a pixel, its uncertainty is at least kOneKeyUncertainty. If no point lands, it is at
// least kMissedUncertainty.
//
// sRGB codes are approximated by square roots, with an error of up to 10 codes.
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

/// Prediction from one key frame. Where no point of this key frame lands, the pixel has the colour predicted from the other key
/// frame.
struct Prediction {
  const Image& colors;
  const SplatBuffer& landed;
};

/// Reuses memory from frame to frame, so it is not thread-safe.
class UncertaintyEstimator {
 public:
  UncertaintyEstimator(const Optics& optics, Encoding encoding);

  /// Sets one entry per pixel. `film` is the prediction from both key frames.
  void estimate(const Prediction& previous, const Prediction& following, const Image& film, const ThreadPool& pool,
                std::vector<std::uint8_t>& uncertainty);

 private:
  /// One value per pixel, and `across_` more values at both ends of each row.
  using Plane = std::vector<std::uint8_t>;

  void make_planes(const Prediction& previous, const Prediction& following, const Image& film, int row);

  int width_, height_, across_, down_;
  std::size_t stride_;
  bool linear_film_;
  Plane disagreement_, codes_[3];
};

}  // namespace lippmann
