// Whether a file that need not be there can be opened. What lies in its place may be a FIFO, and opening that waits forever.
#pragma once

#include <filesystem>

namespace lippmann {

/// False if there is nothing of that name. Throws Error if there is something that is no regular file, or it cannot be looked
/// at.
bool is_regular_file_there(const std::filesystem::path& path);

}  // namespace lippmann
