// Which pixels of a film an eye sees at once, because a display's lenses are not sharp (lippmann/optics/crosstalk.hpp), and how
// much of the picture each of them is.
//
// The eye stands where a view is seen from, and looks at the middle of a pixel below each lens (of a quilt: of a view). There
// it sees the least of the neighbours. Places are film pixels, y * width + x. A step is a number of neighbours across and up or
// down: of lens arrays pixels of the panel, of quilts views, of slanted panels whole pixels, each colour for itself.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

class EyeBlur {
 public:
  /// sigma_px: 0 ... kMaxBlurPx, in the optics' pixels or views; 0: no neighbour is seen.
  EyeBlur(const Optics& optics, double sigma_px);

  bool blurs() const { return reach() != Vec2i(0); }

  /// Neighbours farther away than so many steps are not seen.
  Vec2i reach() const;

  /// The film pixel that lies a step away; none beyond the panel or the outermost view.
  std::optional<std::uint32_t> neighbour(std::uint32_t pixel, Vec2i step) const;

  /// How much is seen of the pixel a step away, far from the edges of the film; all add up to 1.
  double weight(Vec2i step) const;

  /// How much what is seen at two places a step apart has in common: the sum of products of weights. All add up to 1.
  double overlap(Vec2i step) const;

  /// What is left of the squared error of pixels that err independently: the sum of squared weights.
  double own_share() const { return overlap(Vec2i(0)); }

  /// A step as probable as overlap() says, from two random numbers in [0, 1).
  Vec2i draw_overlapping(Vec2d random) const;

 private:
  struct Axis {
    std::vector<double> weights{1.0};   ///< by distance: 0 ... reach
    std::vector<double> overlaps{1.0};  ///< by distance: 0 ... 2 reach
  };
  static Axis make_axis(double sigma_px);
  static int draw(const Axis& axis, double random);

  Axis across_, up_;
  Vec2i size_;      ///< the film's
  int stride_ = 1;  ///< film columns from a pixel of a panel to the next
  std::optional<ViewTiles> tiles_;
  Vec2i tile_{1, 1};  ///< their size
  int padding_top_ = 0;
};

}  // namespace lippmann
