// What a display is looked at through, and from where it is meant to be: its window in the plane z = 0, its viewer, its zone.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/viewer.hpp"

namespace lippmann {

/// A rectangle of the plane z = 0, mm.
struct Window {
  Vec2d centre{0.0}, size{1.0};

  /// A point of it in continuous pixel coordinates of a picture (origin top left, y down) that fills it.
  Vec2d point_at(Vec2d pixel, Vec2i picture) const {
    return centre + Vec2d(pixel.x / picture.x - 0.5, 0.5 - pixel.y / picture.y) * size;
  }
  /// The inverse.
  Vec2d pixel_at(Vec2d point_mm, Vec2i picture) const {
    const Vec2d share = (point_mm - centre) / size;
    return {(share.x + 0.5) * picture.x, (0.5 - share.y) * picture.y};
  }
};

/// The pixels of the picture that a panel shows.
inline Vec2i picture_size(const Optics& optics) { return {optics.panel.width, optics.panel.height}; }

/// The panel (one tile of a quilt) as it is seen in the plane z = 0 from where it is meant to be seen.
Window display_window(const Optics& optics);

/// Whom the display is made for: at its viewing distance, infinitely far where that is infinite.
Viewer design_viewer(const Optics& optics);

/// The eye `share` of the way through the viewing zone, 0 at its left end, 1 at its right, at the design viewer's height and
/// distance. Of N pixels below a lens, or N views, the i-th eye from the left has share (i + 1/2) / N. A single view has one.
Viewer viewer_in_zone(const Optics& optics, double share);
/// The same of the zone from bottom to top; all the same where there is no vertical parallax.
Viewer viewer_in_zone_vertically(const Optics& optics, double share);

/// The x of an eye at distance z that far through the zone as it is seen from the middle of the display.
double zone_x_mm(const Optics& optics, double share, double z_mm);

/// Where an eye stands unless somebody says: at the design viewer's place; at 3 heights of the window where that is infinitely
/// far.
Vec3d default_eye_mm(const Optics& optics);

/// Samples that the plane z = 0 has across and down: one per lens where lenses have power, one per pixel elsewhere.
Vec2i lens_grid(const Optics& optics);

/// How far apart those of one view are, mm: on a slanted panel, too, one per lens along a row.
Vec2d sample_spacing_mm(const Optics& optics);

/// In which directions an eye that moves sees something new.
struct Parallax {
  bool across = true, along = false;
};
Parallax parallax_of(const Optics& optics);

/// The views that can be told apart across and up: pixels below a lens (rounded up), or views.
Vec2i view_counts(const Optics& optics);

/// A picture of square pixels with at least the samples of lens_grid.
Vec2i natural_view_size(const Optics& optics);

/// A pinhole at an eye that sees the window in a picture of `size` pixels, which must have the window's shape: rays for
/// comparison. Its optics are to be traced in a display frame moved by (eye.x, eye.y, 0).
Optics pinhole_through_window(const Window& window, Vec2i size, Vec3d eye_mm);

}  // namespace lippmann
