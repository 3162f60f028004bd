// The presets, data/displays/*.toml, as the program has them in itself. Private to this part.
#pragma once

#include <span>
#include <string_view>

namespace lippmann {

struct PresetFile {
  std::string_view name;  ///< the file's, without its ending
  std::string_view text;
};

/// By name.
std::span<const PresetFile> preset_files();

}  // namespace lippmann
