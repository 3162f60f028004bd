// Combines a focal stack into an all-in-focus image and a depth map.
//
// Each pixel takes the colour and the depth of the refocused image in which its rays agree best. Agreement is measured by the
// variance of the rays' colours (replay/refocus.hpp), averaged over a square window. This is the correspondence cue of Tao,
// Hadap, Malik and Ramamoorthi, "Depth from combining defocus and correspondence using light-field cameras", ICCV 2013, eq. 5.
//
// Unlike the paper, we use the variance instead of the standard deviation, so that large differences weigh more. We use neither
// the defocus cue nor smoothing. On surfaces without texture, the depth is unreliable.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class AllInFocus {
 public:
  /// `size` is the size of the refocused images in pixels.
  AllInFocus(const Optics& optics, Vec2i size);

  /// Adds an image focused at depth z_mm. `disagreement` is the variance of the colours of each pixel's rays, see refocus(). If
  /// two images agree equally well, the first one wins.
  void add(const Image& refocused, const Image& disagreement, double z_mm);

  const Image& picture() const { return picture_; }
  const Image& depth() const { return depth_; }  ///< z in mm in the display frame

 private:
  Vec2i radius_;  ///< half width of the averaging window, in pixels
  Image picture_, depth_, least_;
};

}  // namespace lippmann
