// Whether files lie in the folder that somebody chose to show, and are no links to elsewhere.
#pragma once

#include <filesystem>

namespace lippmann {

/// The folder, or that of the file, without links. Throws Error naming `in` where it does not exist, or a file that describes
/// it (report.json, a side file) and leads out.
std::filesystem::path shown_root(const std::filesystem::path& in);

/// Throws Error naming a file that leads out of `root`, as shown_root has it: `file` itself (a picture, or a folder with all
/// that it holds directly), or one that is read with it: its report, side files and layers. What does not exist is within it.
void require_within(const std::filesystem::path& root, const std::filesystem::path& file);

}  // namespace lippmann
