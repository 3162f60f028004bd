// Checks the parameters of extra layers, including alpha.
#pragma once

#include "job/params.hpp"

namespace lippmann {

/// Throws a usage Error for extra layers of the test pattern, and for alpha in pictures or videos that cannot store it.
void check_aovs(const RenderParams& params);

}  // namespace lippmann
