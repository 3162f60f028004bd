// Describes an image, a video or a folder of images: `lippmann info PICTURE|FOLDER`.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct PictureInfo {
  std::filesystem::path first;
  int frames = 1;
  std::string format = {};  ///< a format of `convert`, or "view", "panel" or "video"; empty if unknown
  Vec2i picture_px{0};
  std::string samples = {};  ///< "8 bits", "16 bits" or "floats"
  std::optional<ViewGrid> views = {};
  Vec2i view_px{0};  ///< size of a view; set if `views` is set
  std::string cameras = {};
  bool has_depth = false;
  std::filesystem::path side_file = {};  ///< <picture>.json, report.json, parameters.cfg or cameras.json
  std::string problem = {};              ///< why the views cannot be read, and what to do; empty if the views can be read
};

PictureInfo describe_picture(const std::filesystem::path& in);

nlohmann::ordered_json to_json(const PictureInfo& info);

std::string to_text(const PictureInfo& info);

}  // namespace lippmann
