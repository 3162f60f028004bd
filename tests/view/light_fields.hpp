// Small light fields in folders as renders leave them.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "view/page_field.hpp"

namespace lippmann::test {

/// Returns 4 lenses of 4 pixels, 6 rows; viewed from 100 mm.
Optics small_sheet();

/// Writes `count` frames of noise, frame_0000.png ..., and report.json. Returns the images.
std::vector<Image8> write_sheet_frames(const std::filesystem::path& folder, int count);

std::vector<std::unique_ptr<PageField>> fields_of(const std::filesystem::path& in);

}  // namespace lippmann::test
