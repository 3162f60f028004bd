// What the parameters say about extra layers, alpha among them.
#pragma once

#include "render/params.hpp"

namespace lippmann {

/// Throws a usage Error for layers that the frames asked for do not have, and for alpha where pictures or videos cannot have
/// it.
void check_aovs(const RenderParams& params);

/// The part of it that has nothing to do with files.
void check_layers(const FrameParams& params);

/// Which layers a frame has to have.
FrameAovs wanted_aovs(const FrameParams& params);

}  // namespace lippmann
