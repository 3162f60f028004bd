// The side file of a plenoptic camera's picture, <picture>.json. It holds the number of views and, if known, their cameras,
// which the picture itself cannot store.
//
//   {"eslf": {"columns": 14, "rows": 14, "pixel_aspect": 1, "positions": [[x, y], ...],
//             "cameras": {"distance_mm": d, "pixel_mm": [w, h], "centre_px": [x, y], "eyes_mm": [[x, y], ...]}}}
//
// `pixel_aspect` is width / height of a view's pixels; if it is missing, it follows from the cameras, or else is 1. `positions`
// and `cameras` are also optional. Lists are in the order of the views; x is to the right and y up, as in LightField.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

struct EslfSideFile {
  ViewGrid grid{};
  double pixel_aspect = 1.0;
  std::optional<std::vector<Vec2d>> positions = {};
  std::optional<ViewCameras> cameras = {};
};

std::filesystem::path eslf_side_path(const std::filesystem::path& picture);

/// Returns none if the side file does not exist or describes something else. Throws Error naming the file.
std::optional<EslfSideFile> read_eslf_side_file(const std::filesystem::path& picture);
/// Returns none for JSON without the key `eslf`. Throws Error naming `where`.
std::optional<EslfSideFile> parse_eslf_side_file(const std::string& text, const std::string& where);

std::string eslf_side_text(const EslfSideFile& side);
std::filesystem::path write_eslf_side_file(const std::filesystem::path& picture, const EslfSideFile& side);

}  // namespace lippmann
