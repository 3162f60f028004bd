// Checks the parameters of extra layers, including alpha.
#pragma once

#include "job/params.hpp"

namespace lippmann {

/// Throws a usage Error if extra layers are requested for the test pattern, or if alpha is requested for pictures or videos
/// that cannot store it.
void check_aovs(const RenderParams& params);

}  // namespace lippmann
