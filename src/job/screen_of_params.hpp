// The screen of a job without a display.
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// The kind of optics makes the panel and the optical model (optics/optics_kind.hpp). Throws a usage Error for parameters that
/// contradict each other (job/panel_size.hpp). Screen::optics throws a usage Error if the lens pitch would be smaller than a
/// pixel.
Screen screen_of_params(const RenderParams& params, const Scene& scene);

}  // namespace lippmann
