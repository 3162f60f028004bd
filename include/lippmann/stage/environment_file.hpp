// Reads a panorama that lights a scene from a file.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Reads an equirectangular .hdr or .exr with linear light; grey is repeated in all channels. Clamps negative samples to 0.
/// strength: factor for the light. rotation_deg: rotation about the vertical. Warns about ignored data in the file. Throws
/// Error that names the file.
EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg,
                                const Context& context = Context());

}  // namespace lippmann
