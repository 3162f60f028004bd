// Reads a panorama that lights a scene.
#pragma once

#include <filesystem>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// Reads an equirectangular .hdr or .exr file with linear light. Negative samples become 0. `strength` multiplies the light,
/// and `rotation_deg` rotates it about the vertical. Warns about ignored data of the file. Throws Error naming the file.
EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg,
                                const Context& context = Context());

}  // namespace lippmann
