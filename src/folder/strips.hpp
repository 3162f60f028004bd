// The files of strips: rows of a frame, film and layers as floats, that wait in a render's folder until all of them are there
// and the frame is joined from them.
#pragma once

#include <filesystem>
#include <optional>

#include "folder/journal.hpp"
#include "lippmann/frames/rendered_frame.hpp"

namespace lippmann {

/// The figures of a strip that the journal records and whose file is as it was written; else none. Reads the file.
std::optional<FrameReport> find_strip(const std::filesystem::path& folder, const FolderJournal& journal, int frame, int strip);

/// Writes a strip's file, whole or not at all. Throws Error naming it.
FileRecords write_strip(const std::filesystem::path& folder, int frame, int strip, const FramePictures& pictures);

/// Reads a strip into the rows of a film, from `first_row` on, and of the layers that are wanted, which have all its size.
/// Throws Error for a file that does not hold just these rows.
void read_strip(const std::filesystem::path& file, int first_row, int rows, FramePictures& into);

/// Removes the files of all strips of a frame, recorded or not. Throws Error naming one that cannot be removed.
void remove_strips(const std::filesystem::path& folder, int frame, int count);

}  // namespace lippmann
