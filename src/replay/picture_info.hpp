// Describes an image, a video or a folder of images: `lippmann info PICTURE|FOLDER`.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

struct PictureInfo {
  std::filesystem::path first;         ///< the image or folder that the other members describe
  int frames = 1;                      ///< number of frames in a folder
  std::string format = {};             ///< a format of `convert`, or "view", "panel" or "video"; empty: unknown
  Vec2i picture_px{0};                 ///< size of the image, or of the folder's first image
  std::string samples = {};            ///< "8 bits", "16 bits" or "floats"
  std::optional<ViewGrid> views = {};  ///< number of views; none: unknown
  Vec2i view_px{0};                    ///< size of a view; set if `views` is set
  std::string cameras = {};            ///< description of the cameras for the user; empty: unknown
  bool has_depth = false;
  std::filesystem::path side_file = {};  ///< <picture>.json, report.json, parameters.cfg or cameras.json; empty: none
  std::string problem = {};              ///< why the views cannot be read, and what to do about it; empty: no problem
};

/// Describes the input. Throws Error naming the file or folder if it has no image.
PictureInfo describe_picture(const std::filesystem::path& in);

nlohmann::ordered_json to_json(const PictureInfo& info);

/// Returns a description of several lines for the user.
std::string to_text(const PictureInfo& info);

}  // namespace lippmann
