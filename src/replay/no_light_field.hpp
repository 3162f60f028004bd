// Rejects inputs that are not light fields. The messages name what the input is instead.
#pragma once

#include <filesystem>

namespace lippmann {

/// Throws an Error naming `in` if it is a video, or a folder without frames or views. The message distinguishes an empty
/// folder, one with videos, one with a job that has not been rendered, and one whose images have unknown names.
void require_light_field(const std::filesystem::path& in);

/// Throws an Error naming the file if its extension is not an image extension.
void require_picture_name(const std::filesystem::path& file);

}  // namespace lippmann
