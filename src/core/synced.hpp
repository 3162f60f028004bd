// That what was written survives a loss of power: bytes that a program has written lie in memory for a while, and so do the
// names of files.
#pragma once

#include <filesystem>

namespace lippmann {

/// Waits until a file's bytes are on the disk. Throws Error naming the file where they cannot be written. File systems that
/// know of no such wait (some of those in user space) are taken as they are.
void sync_file(const std::filesystem::path& file);

/// The same of the names in a folder: which files there are. An empty path is the working folder.
void sync_folder(const std::filesystem::path& folder);

/// The same of an open file, but 0 or an errno.
int sync_descriptor(int descriptor);

}  // namespace lippmann
