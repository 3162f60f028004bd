// Where the pixels of a light field's views came from, as the render that made it says beside its pictures.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Values of Provenance (lippmann/trace/aovs.hpp), 1 channel, one view below the other as field.stack has them. `path` is a
/// picture, integral or a quilt, or a folder of views, which `field` was read from. None where a layer is missing or of another
/// size. Throws Error as read_channels.
std::optional<Image> views_provenance(const std::filesystem::path& path, const LightField& field);

}  // namespace lippmann
