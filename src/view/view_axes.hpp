// Which eyes the views of a page stand for, along one axis: equally far apart in slope, or in angle.
//
// An eye is its slope at the middle of the display (optics/viewer.hpp), so that eyes of displays for an infinitely far viewer
// are described in the same way as others. View i has T(slope) = first + i step, T the identity, or the arc tangent where
// `by_angle`.
#pragma once

#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// What an eye sees that is beyond the outermost views.
enum class BeyondZone {
  kRepeats,   ///< the views of the next cone
  kNextLens,  ///< those of the neighbouring lens
  kStays,     ///< the outermost view
};

struct ViewAxis {
  int count = 1;
  double first = 0.0, step = 0.0;
  bool by_angle = false;
  BeyondZone beyond = BeyondZone::kStays;

  double slope(double view) const;
};

struct ViewAxes {
  ViewAxis across, up;
  double vergence = 0.0;  ///< 1 / distance, per mm, the same for all of these eyes
};

/// The axes of the views of whole pixels that these optics have, or of eyes in as many directions as can be told apart.
ViewAxes view_axes(const Optics& optics, ViewGrid grid);

}  // namespace lippmann
