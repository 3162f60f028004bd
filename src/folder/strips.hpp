// A strip's file holds rows of a frame's film and layers, as floats, until the frame is joined.
#pragma once

#include <filesystem>
#include <optional>

#include "folder/journal.hpp"
#include "lippmann/frames/rendered_frame.hpp"

namespace lippmann {

/// Reads the file of a recorded strip. Returns its report, or nullopt if the file does not match the record.
std::optional<FrameReport> find_strip(const std::filesystem::path& folder, const FolderJournal& journal, int frame, int strip);

/// Writes the file atomically and returns its record. Throws Error that names the file.
FileRecords write_strip(const std::filesystem::path& folder, int frame, int strip, const FramePictures& pictures);

/// Reads a strip into the rows `first_row` to `first_row + rows - 1` of a film and its layers, which must have their
/// full size. Throws Error if the file has other rows.
void read_strip(const std::filesystem::path& file, int first_row, int rows, FramePictures& into);

/// Removes the files of all strips of a frame, recorded or not. Throws Error that names a file that cannot be removed.
void remove_strips(const std::filesystem::path& folder, int frame, int count);

}  // namespace lippmann
