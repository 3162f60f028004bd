// The panorama that lights a scene, read from the user's file.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// An equirectangular .hdr or .exr, linear: its colours, or grey three times. Negative samples become 0. strength: factor;
/// rotation_deg: about the vertical. Warns about what the file says and is not honoured. Throws Error naming the file.
EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg,
                                const Context& context = Context());

}  // namespace lippmann
