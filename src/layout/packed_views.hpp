// All views of a light field in one picture, as layout/view_layout.hpp says where: to and from a stack.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Throws Error naming the file if views do not fill it as that layout wants. with_depth: the layer of depth too, where there
/// is one (layout/rendered.hpp). warn: as read_picture.
LightField read_packed(const std::filesystem::path& path, const ViewLayout& layout, bool with_depth,
                       const std::function<void(std::string_view)>& warn);

/// Throws Error naming the file as write_picture does.
std::vector<std::filesystem::path> write_packed(const LightField& field, const ViewLayout& layout,
                                                const std::filesystem::path& path);

}  // namespace lippmann
