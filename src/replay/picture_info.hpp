// `lippmann info PICTURE|FOLDER`: what a picture, a video or a folder of pictures is.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct PictureInfo {
  std::filesystem::path first;  ///< the picture or folder that the following is about
  int frames = 1;               ///< that a folder holds
  std::string format = {};  ///< of `convert`; "view" and "panel": a single view, or what a panel shows; "video"; empty: unknown
  Vec2i picture_px{0};      ///< of the picture, or of the folder's first picture
  std::string samples = {};            ///< "8 bits", "16 bits" or "floats"
  std::optional<ViewGrid> views = {};  ///< none: unknown
  Vec2i view_px{0};                    ///< with views
  std::string cameras = {};            ///< in words; empty: unknown
  bool has_depth = false;
  std::filesystem::path side_file = {};  ///< that describes it: its own .json, report.json, parameters.cfg or cameras.json
  std::string problem = {};              ///< why its views cannot be read, with what would help
};

/// Throws Error naming the file or folder where there is no picture.
PictureInfo describe_picture(const std::filesystem::path& in);

nlohmann::ordered_json to_json(const PictureInfo& info);

/// Several lines for people.
std::string to_text(const PictureInfo& info);

}  // namespace lippmann
