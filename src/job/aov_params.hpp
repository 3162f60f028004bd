// What the parameters say about extra layers, alpha among them.
#pragma once

#include "job/params.hpp"

namespace lippmann {

/// Throws a usage Error for extra layers of the test pattern, and for alpha where pictures or videos cannot have it.
void check_aovs(const RenderParams& params);

}  // namespace lippmann
