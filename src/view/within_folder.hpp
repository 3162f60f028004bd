// Checks that files are inside the folder chosen by the user, and are not links to files elsewhere.
#pragma once

#include <filesystem>

namespace lippmann {

/// Returns the folder `in`, or the folder of the file `in`, with links resolved. Throws Error naming `in` if it does not exist,
/// or naming a report or side file that is a link out of the folder.
std::filesystem::path shown_root(const std::filesystem::path& in);

/// Throws Error naming a file outside `root`. Checks `file` (an image, or a folder with its direct entries) and the reports,
/// side files and layers that are read with it. Missing files pass.
void require_within(const std::filesystem::path& root, const std::filesystem::path& file);

}  // namespace lippmann
