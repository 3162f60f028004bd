// Smart pseudoscopic-to-orthoscopic conversion (SPOC): the image for a display's lens array from the image of a recording
// array.
//
// Based on: Navarro, Martinez-Cuenca, Molina-Martin, Martinez-Corral, Saavedra and Javidi, "Method to remedy image degradations
// due to facet braiding in 3D integral-imaging monitors", J. Display Technol. 6(10), 2010; Martinez-Corral, Dorado, Navarro,
// Saavedra and Javidi, "Three-dimensional display by smart pseudoscopic-to-orthoscopic conversion with tunable focus", Appl.
// Opt. 53(22), 2014.
//
// Shown by the recording array itself, the image would have inverted depth. The conversion therefore places the display's array
// at distance D in front of the recording array, facing it. Depth Z on the display is z = D - Z in front of the recording
// array. Points nearer to the recording array come nearer to the viewer, and points at distance D lie in the display plane.
//
//   A pixel at offset o below the display's lens l (pitch p, gap g) has the ray x(Z) = l - o Z / g.
//   1. It meets the recording array, Z = D, at              x_R = l - o D / g;
//      the nearest recording lens is                        k = round((x_R - l_0') / p'), with its centre l' = l_0' + k p'.
//   2. It meets the reference plane, z = z_ref in front of the recording array, that is Z = D - z_ref, at
//                                                           x_ref = l - o (D - z_ref) / g.
//   3. Below lens l', the point (x_ref, z_ref) is seen at   o' = -(x_ref - l') g' / z_ref:
//      pixel floor(N'/2 + o' / m') of cell k.
// With D = 0 and equal arrays, k is the lens itself, x_ref = l + o z_ref / g, and o' = -o: rotated elemental images.
//
// We deviate: if the nearest lens has no pixel that looks at the point, the nearest lens with such a pixel is used. Without any
// such lens, the pixel is black.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "replay/pixel_map.hpp"

namespace lippmann {

struct SpocParams {
  double distance_mm = 20.0;   ///< D: points at this distance from the recording array appear in the display plane
  double reference_mm = 20.0;  ///< z_ref, > 0: distance from the recording array that is reproduced best
};

struct SpocDisplay {
  double lens_pitch_mm = 1.0, gap_mm = 2.0;
  int pixels = 8;
};

/// Returns an array of the recording array's kind and window, with the pitch, gap and pixels per lens of `display`. Throws a
/// usage Error for values that make no valid array.
Optics spoc_display(const Optics& recorded, const SpocDisplay& display);

/// `recorded` and `display` are lens arrays of one kind. Throws a usage Error if a distance is not finite, or if the reference
/// plane is not in front of the recording array.
PixelMap spoc(const Optics& recorded, const Optics& display, const SpocParams& params);

}  // namespace lippmann
