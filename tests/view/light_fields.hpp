#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "view/page_field.hpp"

namespace lippmann::test {

Optics small_sheet();

std::vector<Image8> write_sheet_frames(const std::filesystem::path& folder, int count);

std::vector<std::unique_ptr<PageField>> fields_of(const std::filesystem::path& in);

}  // namespace lippmann::test
