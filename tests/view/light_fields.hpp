// Writes small light fields to folders, as a render does.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "view/page_field.hpp"

namespace lippmann::test {

/// 4 lenses of 4 pixels and 6 rows, seen from 100 mm.
Optics small_sheet();

/// Writes frames of noise, frame_0000.png and so on, and report.json. Returns the frames.
std::vector<Image8> write_sheet_frames(const std::filesystem::path& folder, int count);

std::vector<std::unique_ptr<PageField>> fields_of(const std::filesystem::path& in);

}  // namespace lippmann::test
