// Smart pseudoscopic-to-orthoscopic conversion (SPOC): what a display's array has to show, of what another one recorded.
//
// Based on: Navarro, Martinez-Cuenca, Molina-Martin, Martinez-Corral, Saavedra and Javidi, "Method to remedy image degradations
// due to facet braiding in 3D integral-imaging monitors", J. Display Technol. 6(10), 2010; Martinez-Corral, Dorado, Navarro,
// Saavedra and Javidi, "Three-dimensional display by smart pseudoscopic-to-orthoscopic conversion with tunable focus", Appl.
// Opt. 53(22), 2014.
//
// The recorded picture, shown by its own array, would be seen in wrong depth: a scene point at (x, z) before that array, which
// recorded it from behind, shows itself from its back. The display's array is set up at the distance D before the recording
// one, facing it: depth Z on the display is z = D - Z before the recording array, so that what was nearer to that array comes
// nearer to the viewer, and what stood at D comes into the display's plane.
//
//   A pixel at offset o below the display's lens l (pitch p, gap g) has the ray x(Z) = l - o Z / g.
//   1. It meets the recording array, Z = D, at              x_R = l - o D / g;
//      the recorded lens nearest to that                     k = round((x_R - l_0') / p'), with its centre l' = l_0' + k p'.
//   2. It meets the reference plane, z = z_ref before the recording array, that is Z = D - z_ref, at
//                                                            x_ref = l - o (D - z_ref) / g.
//   3. Below lens l', the point (x_ref, z_ref) is seen at    o' = -(x_ref - l') g' / z_ref:
//      pixel floor(N'/2 + o' / m') of cell k.
// With D = 0 and equal arrays k is the lens itself, x_ref = l + o z_ref / g, and o' = -o: rotated elemental images.
//
// As the papers' lenses but for any array, the reference point takes the place of the eye in optics/sight.hpp. We deviate:
// where the nearest lens has no pixel that looks at the point, the nearest one that has is taken, so that no pixel stays black
// unless none has.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "replay/pixel_map.hpp"

namespace lippmann {

struct SpocParams {
  double distance_mm = 20.0;   ///< D: what stood so far before the recording array comes into the display's plane
  double reference_mm = 20.0;  ///< z_ref, > 0: where the scene is best kept
};

/// The display's array of `pixels` below each lens of that pitch and gap, over the window that the recorded one fills, cells
/// straight below their lenses; of the recorded array's kind. Throws a usage Error for what makes no array.
struct SpocDisplay {
  double lens_pitch_mm = 1.0, gap_mm = 2.0;
  int pixels = 8;
};
Optics spoc_display(const Optics& recorded, const SpocDisplay& display);

/// The picture of the display's panel, made of pictures of the recorded one. Both are lens arrays of one kind. Throws a usage
/// Error for distances that are not finite, or a reference plane that is not before the recording array.
PixelMap spoc(const Optics& recorded, const Optics& display, const SpocParams& params);

}  // namespace lippmann
