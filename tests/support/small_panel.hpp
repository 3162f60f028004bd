#pragma once

#include <filesystem>
#include <fstream>

namespace lippmann::test {

/// A slanted panel of 48 x 64 pixels, with a quilt of 4 x 2 views. The last column of the quilt belongs to no view.
inline void write_small_panel(const std::filesystem::path& file) {
  std::ofstream(file) << R"(description = "small"
kind = "slanted-panel"
pixels = [48, 64]
dpi = 324
view_cone_deg = 40
[calibration]
pitch = 52.0
slope = -7.0
center = 0.5
[quilt]
tiles = [4, 2]
size = [129, 128]
aspect = 0.75
)";
}

}  // namespace lippmann::test
