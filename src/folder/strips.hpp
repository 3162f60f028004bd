// Reads and writes the files of strips. A strip's file holds rows of a frame's film and layers as floats, and stays in the
// render's folder until the frame is joined.
#pragma once

#include <filesystem>
#include <optional>

#include "folder/journal.hpp"
#include "lippmann/frames/rendered_frame.hpp"

namespace lippmann {

/// Returns the figures of a recorded strip if its file matches the record, else nullopt. Reads the file.
std::optional<FrameReport> find_strip(const std::filesystem::path& folder, const FolderJournal& journal, int frame, int strip);

/// Writes a strip's file atomically. Throws Error naming the file.
FileRecords write_strip(const std::filesystem::path& folder, int frame, int strip, const FramePictures& pictures);

/// Reads a strip into `rows` rows, starting at `first_row`, of a film and its layers, which are allocated at full size. Throws
/// Error for a file with other rows.
void read_strip(const std::filesystem::path& file, int first_row, int rows, FramePictures& into);

/// Removes the files of all strips of a frame, recorded or not. Throws Error naming one that cannot be removed.
void remove_strips(const std::filesystem::path& folder, int frame, int count);

}  // namespace lippmann
