// Rejects inputs that are not light fields, with messages that name what the input is instead.
#pragma once

#include <filesystem>

namespace lippmann {

/// Throws an Error naming `in` if it is a video, or a folder without frames or views.
void require_light_field(const std::filesystem::path& in);

void require_picture_name(const std::filesystem::path& file);

}  // namespace lippmann
