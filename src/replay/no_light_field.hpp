// What lies where a light field was expected, for a message that says more than that there is none.
#pragma once

#include <filesystem>

namespace lippmann {

/// Throws an Error naming `in` where it is a video, or a folder without frames and views that is empty or holds videos, a job
/// that has not been rendered, or pictures of other names.
void refuse_what_is_no_light_field(const std::filesystem::path& in);

/// Throws an Error naming a file whose ending is that of no picture.
void require_picture_name(const std::filesystem::path& file);

}  // namespace lippmann
