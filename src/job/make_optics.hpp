// The optics that the parameters ask for, on the array that was fitted to the scene.
//
// Lenses are 1 mm wide on the panel; all that matters is proportion: the panel is scaled to the fitted plane. Of a lens cell
// c = pixels x pitch wide and a viewing zone of full angle a, the gap is g = c / (2 tan(a/2)); cells that converge to a viewer
// at distance V belong to lenses of pitch p = c / (1 + g/V). Of a camera grid the viewing zone is divided among the N eyes of
// its longer side: they stand 2 V tan(a/2) / N apart.
#pragma once

#include "job/params.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/placement.hpp"

namespace lippmann {

/// The optics of the display where one is given (job/display_optics.hpp), else those of the parameters alone.
/// Rays start where the fitted viewer stands, so that a camera inside a room sees the room.
/// Throws a usage Error for parameters that contradict each other (job/panel_size.hpp) or make no rays.
PlacedOptics make_optics(const RenderParams& params, const Scene& scene, const FittedArray& array,
                         const Display* display = nullptr);

/// Width / height of what is seen of the display plane: the panel, or one view of a quilt. Throws likewise.
float window_aspect(const RenderParams& params, Vec2i scene_resolution, const Display* display = nullptr);

}  // namespace lippmann
