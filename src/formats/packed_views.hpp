// Reads and writes pictures that hold all views of a light field (layout/view_layout.hpp).
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Reads a picture. with_depth: whether to read its depth layer, if there is one (formats/rendered.hpp). warn: as in
/// read_picture(). Throws Error naming the file if views of equal size do not fill the picture.
LightField read_packed(const std::filesystem::path& path, const ViewLayout& layout, bool with_depth,
                       const std::function<void(std::string_view)>& warn);

/// Returns the paths of the files written. Throws Error naming the file, as write_picture() does.
std::vector<std::filesystem::path> write_packed(const LightField& field, const ViewLayout& layout,
                                                const std::filesystem::path& path);

}  // namespace lippmann
