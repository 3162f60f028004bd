// Layers of a light field's views, as the render that made it wrote them beside its pictures.
//
// A layer is a stack, one view below the other as field.stack has them. `path` is a picture, integral or a quilt, or a folder
// of views, which `field` was read from. None where a layer is missing or of another size. All throw Error as read_channels.
#pragma once

#include <filesystem>
#include <optional>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Where pixels came from: values of Provenance (lippmann/trace/aovs.hpp), 1 channel.
std::optional<Image> views_provenance(const std::filesystem::path& path, const LightField& field);

/// By how many pixels of its view each point has moved since the frame before: 2 channels, right and down.
std::optional<Image> views_motion(const std::filesystem::path& path, const LightField& field);

}  // namespace lippmann
