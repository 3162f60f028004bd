// Checks that files are inside the folder chosen by the user and are not links to files elsewhere.
#pragma once

#include <filesystem>

namespace lippmann {

/// Returns the folder `in`, or the folder of the file `in`, with links resolved. Throws Error naming `in` if it does not exist.
/// Throws Error naming a file that describes `in` (report.json, a side file) if that file is a link that leads out of the
/// folder.
std::filesystem::path shown_root(const std::filesystem::path& in);

/// Throws Error naming a file outside `root` (see shown_root). Checks `file` itself (an image, or a folder with its direct
/// entries) and the files that are read with it, such as its report, side files and layers. Files that do not exist pass.
void require_within(const std::filesystem::path& root, const std::filesystem::path& file);

}  // namespace lippmann
