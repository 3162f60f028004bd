// Turns orthoscopic pictures into pseudoscopic ones and back: every elemental image is rotated by 180 degrees.
//
// Okano, Hoshino, Arai and Yuyama, "Real-time pickup method for a three-dimensional image based on integral photography", Appl.
// Opt. 36(7), 1997. A pixel at offset o from its cell's centre has the ray x = l - o z / g; at -o it has that of -z: what stood
// at depth z before the lenses stands at the same place at -z behind them. Twice is the identity. Below a sheet, each row of an
// elemental image is mirrored; of a quilt, the order of the views is turned round.
#pragma once

#include <string>

#include "lippmann/optics/optics.hpp"
#include "replay/pixel_map.hpp"

namespace lippmann {

/// For pictures of the optics' panel. Pixels whose counterpart lies beyond the panel, below a lens that it cuts, become black.
/// Throws Error naming `where` for lens arrays without whole pixels below a lens.
PixelMap rotated_elemental_images(const Optics& optics, const std::string& where);

}  // namespace lippmann
