// The screen of a job that names no display.
//
// Lenses are 1 mm wide on the panel; all that matters is proportion: the panel is scaled to the fitted plane. Of a lens cell
// c = pixels x pitch wide and a viewing zone of full angle a, the gap is g = c / (2 tan(a/2)); cells that converge to a viewer
// at distance V belong to lenses of pitch p = c / (1 + g/V). Of a camera grid the viewing zone is divided among the N eyes of
// its longer side: they stand 2 V tan(a/2) / N apart.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Throws a usage Error for parameters that contradict each other (job/panel_size.hpp). Its optics() throws one where the
/// lenses would lie closer to the pixels than these are wide.
Screen screen_of_params(const RenderParams& params, const Scene& scene);

}  // namespace lippmann
