// What the parameters say about extra layers.
#pragma once

#include "render/params.hpp"

namespace lippmann {

/// Throws a usage Error for layers that the frames asked for do not have.
void check_aovs(const RenderParams& params);

/// Which layers a frame has to have.
FrameAovs wanted_aovs(const RenderParams& params);

}  // namespace lippmann
