// Reads a panorama that lights a scene from a file.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Reads an equirectangular .hdr or .exr file with linear light. A grey image gets three equal channels. Negative samples
/// become 0. `strength` is a factor for the light. `rotation_deg` is the rotation about the vertical. Warns about data of the
/// file that is ignored. Throws Error that names the file.
EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg,
                                const Context& context = Context());

}  // namespace lippmann
