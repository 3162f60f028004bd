// All views of a light field in one picture, as layout/view_layout.hpp says where: to and from a stack.
#pragma once

#include <filesystem>

#include "layout/light_field.hpp"

namespace lippmann {

/// Throws Error naming the file if views do not fill it as that layout wants.
LightField read_packed(const std::filesystem::path& path, const ViewLayout& layout);

/// The same places of a layer beside the picture (depth), which must be of its size.
Image unpack_layer(const Image& layer, const ViewLayout& layout, Vec2i view_size);

/// Throws Error naming the file as write_picture does.
std::vector<std::filesystem::path> write_packed(const LightField& field, const ViewLayout& layout,
                                                const std::filesystem::path& path);

}  // namespace lippmann
