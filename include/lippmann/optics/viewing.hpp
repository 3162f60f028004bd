// The geometry of looking at a display: its window in the plane z = 0, its design viewer and its viewing zone.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// A rectangle in the plane z = 0, in mm.
struct Window {
  Vec2d centre{0.0}, size{1.0};

  /// Returns the point of the plane z = 0 shown by a pixel of a picture that fills the window. Pixel coordinates are continuous
  /// (origin top left, y down).
  Vec2d point_at(Vec2d pixel, Vec2i picture) const {
    return centre + Vec2d(pixel.x / picture.x - 0.5, 0.5 - pixel.y / picture.y) * size;
  }
  /// Returns the pixel that shows a point. Inverse of point_at().
  Vec2d pixel_at(Vec2d point_mm, Vec2i picture) const {
    const Vec2d share = (point_mm - centre) / size;
    return {(share.x + 0.5) * picture.x, (0.5 - share.y) * picture.y};
  }
};

inline Vec2i picture_size(const Optics& optics) { return {optics.panel.width, optics.panel.height}; }

/// Returns the part of the plane z = 0 that the design viewer sees through the panel (or through one tile of a quilt).
Window display_window(const Optics& optics);

/// Returns the viewer that the display is made for, who may be infinitely far away.
Viewer design_viewer(const Optics& optics);

/// Returns the eye at `share` of the viewing zone, from 0 at its left end to 1 at its right end, at the design viewer's height
/// and distance. With N pixels per lens, or N views, the i-th eye from the left has share (i + 1/2) / N. For a single view, the
/// eye is the same for every share.
Viewer viewer_in_zone(const Optics& optics, double share);
/// Returns the eye at `share` of the viewing zone, from 0 at its bottom to 1 at its top. Without vertical parallax, the eye is
/// the same for every share.
Viewer viewer_in_zone_vertically(const Optics& optics, double share);

/// Returns the x in mm of an eye at `share` of the viewing zone (0 to 1) and at the distance z_mm from the display.
double zone_x_mm(const Optics& optics, double share, double z_mm);

/// Returns the default eye position: the design viewer's, or 3 window heights in front of the display if the design viewer is
/// infinitely far away.
Vec3d default_eye_mm(const Optics& optics);

/// Returns the number of samples of one view in the plane z = 0, across and down: one sample per lens along axes with lens
/// power, and one per pixel along other axes.
Vec2i lens_grid(const Optics& optics);

/// Returns the spacing of one view's samples in mm. Across a slanted panel, the spacing is the distance between lenses along a
/// row.
Vec2d sample_spacing_mm(const Optics& optics);

/// Whether the picture changes as the eye moves horizontally (across) and vertically (along).
struct Parallax {
  bool across = true, along = false;
};
Parallax parallax_of(const Optics& optics);

/// Returns the number of distinct views across and up. For lenses, it is the number of pixels below a lens, rounded up.
Vec2i view_counts(const Optics& optics);

/// Returns the size of a picture with square pixels that has at least as many samples as lens_grid().
Vec2i natural_view_size(const Optics& optics);

/// Returns the optics of a pinhole camera at eye_mm. Its picture of `size` pixels shows exactly the window. `size` must have
/// the window's aspect ratio. To render a reference picture, trace these optics in a display frame that is moved by (eye.x,
/// eye.y, 0).
Optics pinhole_through_window(const Window& window, Vec2i size, Vec3d eye_mm);

}  // namespace lippmann
