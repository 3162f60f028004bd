// The eyes of a page's views along one axis, equally spaced in slope or in angle.
//
// An eye is given by its slope at the middle of the display (optics/viewer.hpp). For view i, T(slope) = first + i * step, where
// T is the arc tangent if by_angle is set, otherwise the identity.
#pragma once

#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// The views that an eye beyond the outermost views sees.
enum class BeyondZone {
  kRepeats,   ///< the same views again, in the next viewing cone
  kNextLens,  ///< the views of the neighbouring lens
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
  double vergence = 0.0;
};

/// Returns the eyes of the views. If the pixels of views are not whole pixels of the panel, returns eyes in all directions
/// that the panel distinguishes.
ViewAxes view_axes(const Optics& optics, ViewGrid grid);

}  // namespace lippmann
