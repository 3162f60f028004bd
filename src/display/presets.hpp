// The presets data/displays/*.toml, embedded in the program. Private to src/display.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

struct PresetFile {
  std::string_view name;  ///< file name without its ending
  std::string_view text;
};

/// Returns the presets, sorted by name.
std::span<const PresetFile> preset_files();

}  // namespace lippmann
