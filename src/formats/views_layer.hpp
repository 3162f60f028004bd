// Reads layers of a light field's views, which the render wrote beside its pictures. A layer is a stack like
// field.stack. `path` is the picture or the folder of views that `field` was read from. The functions return none if a
// layer is missing or has another size, and throw Error as read_channels() does.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// How each pixel was made: values of Provenance (lippmann/trace/aovs.hpp), 1 channel.
std::optional<Image> views_provenance(const std::filesystem::path& path, const LightField& field);

/// Motion of each point since the previous frame, in pixels of its view: 2 channels, right and down.
std::optional<Image> views_motion(const std::filesystem::path& path, const LightField& field);

}  // namespace lippmann
