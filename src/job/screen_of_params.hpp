// The screen of a job that names no display. The kind of its optics makes panel and model of the parameters
// (optics/optics_kind.hpp).
#pragma once

#include "job/params.hpp"
#include "job/screen.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Throws a usage Error for parameters that contradict each other (job/panel_size.hpp). Its optics() throws one where the
/// lenses would lie closer to the pixels than these are wide.
Screen screen_of_params(const RenderParams& params, const Scene& scene);

}  // namespace lippmann
