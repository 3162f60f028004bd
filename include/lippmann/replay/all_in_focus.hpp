// Takes at every pixel the one of several refocused pictures that is in focus, and the depth at which it was: everything sharp,
// and a depth map.
//
// In focus is where the rays of a pixel agree: where they come from one point of a surface, they have its colour from wherever
// they are seen. The measure is the variance of their colours (replay/refocus.hpp), averaged over a square window, as the
// correspondence cue of Tao, Hadap, Malik and Ramamoorthi, "Depth from combining defocus and correspondence using light-field
// cameras", ICCV 2013, eq. 5. We deviate: the variance itself instead of its root, so that large differences count for more,
// and no second cue or smoothing. On an even wall rays agree at any depth: there the picture is right and the depth means
// little.
#pragma once

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class AllInFocus {
 public:
  /// For pictures of `size` over the display's window.
  AllInFocus(const Optics& optics, Vec2i size);

  /// The next of the pictures, with the disagreement of its rays, focused at z. Where several agree equally well, the first
  /// counts.
  void add(const Image& refocused, const Image& disagreement, double z_mm);

  const Image& picture() const { return picture_; }
  const Image& depth() const { return depth_; }  ///< 1 channel, mm of the display frame

 private:
  Vec2i radius_;  ///< how far the window reaches to each side, pixels
  Image picture_, depth_, least_;
};

}  // namespace lippmann
