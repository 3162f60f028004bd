// Whether files lie in the folder that somebody chose to show, and are no links to elsewhere.
#pragma once

#include <filesystem>

namespace lippmann {

/// The folder, or that of the file, without links. Throws Error naming `in` where it does not exist.
std::filesystem::path shown_root(const std::filesystem::path& in);

/// Throws Error naming `file` (a file, or a folder with all that it holds directly) where it leads out of `root`, as shown_root
/// has it. What does not exist is within it.
void require_within(const std::filesystem::path& root, const std::filesystem::path& file);

}  // namespace lippmann
