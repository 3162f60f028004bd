#pragma once

#include <span>
#include <string_view>

namespace lippmann {

struct PresetFile {
  std::string_view name;
  std::string_view text;
};

std::span<const PresetFile> preset_files();

}  // namespace lippmann
