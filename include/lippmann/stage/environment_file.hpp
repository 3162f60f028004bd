// The panorama that lights a scene, read from the user's file.
#pragma once

#include <filesystem>

#include "lippmann/scene/scene.hpp"

namespace lippmann {

/// An equirectangular .hdr or .exr, linear; of more channels the first three, of one that one three times. Negative samples
/// become 0. strength: factor; rotation_deg: about the vertical. Throws Error naming the file.
EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg);

}  // namespace lippmann
