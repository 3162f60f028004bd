// Combines a focal stack into an all-in-focus image and a depth map.
//
// Each pixel takes the colour and the depth of the refocused image in which its rays agree best, because rays from one surface
// point have the same colour in every view. Agreement is measured by the variance of the colours (replay/refocus.hpp), averaged
// over a square window. This is the correspondence cue of Tao, Hadap, Malik and Ramamoorthi, "Depth from combining defocus and
// correspondence using light-field cameras", ICCV 2013, eq. 5.
//
// We deviate from the paper: we use the variance instead of its square root, so that large differences weigh more. We use no
// second cue and no smoothing. On surfaces without texture the rays agree at every depth: the colour is right, but the depth is
// unreliable.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class AllInFocus {
 public:
  /// size: pixels of the refocused images, which cover the display's window.
  AllInFocus(const Optics& optics, Vec2i size);

  /// Adds a refocused image of the stack. disagreement: the variance of the colours of each pixel's rays (1 channel, see
  /// refocus()). z_mm: the depth of focus. If two images agree equally well, the one added first wins.
  void add(const Image& refocused, const Image& disagreement, double z_mm);

  const Image& picture() const { return picture_; }
  const Image& depth() const { return depth_; }  ///< one channel: z in mm in the display frame

 private:
  Vec2i radius_;  ///< half width of the averaging window, in pixels
  Image picture_, depth_, least_;
};

}  // namespace lippmann
