// Checks that files are inside the folder chosen by the user, and not links to files elsewhere.
#pragma once

#include <filesystem>

namespace lippmann {

/// Returns the folder, or the folder of the file, with links resolved. Throws Error naming `in` if it does not exist, or naming
/// a file that describes it (report.json, a side file) and links outside.
std::filesystem::path shown_root(const std::filesystem::path& in);

/// Throws Error naming a file outside of `root` (see shown_root): `file` itself (an image, or a folder with its direct
/// entries), or a file read with it, such as its report, side files and layers. Files that do not exist pass.
void require_within(const std::filesystem::path& root, const std::filesystem::path& file);

}  // namespace lippmann
