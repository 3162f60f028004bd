// The data beside the pictures that each format of light fields keeps. convert() reports data that the output format cannot
// keep.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

enum class DataKind {
  kOtherViews,  ///< views other than the middle one
  kCameras,
  kPoses,
  kPositions,
  kOffAxis,  ///< pictures that the axes of the cameras do not meet in the middle
  kPixelAspect,
  kDepth,
  kViewDepth,
  kDepthBounds,
  kPoints,
  kSplit,
  kValidation,  ///< views for validation, as opposed to testing
  kTimes,
  kAlpha,
  kHciNotes,
};

struct KeptData {
  DataKind kind{};
  std::string_view name{};                    ///< as in docs/reference/layouts.md
  std::vector<std::string_view> formats{};    ///< formats that can be written and keep the data
  std::string (*found)(const LightField&){};  ///< describes the data, such as "12 points"; empty if there are none
};

/// Returns one row per kind of data. Depth and entries of parameters.cfg are kept only together with cameras, which `stanford`
/// states only for square pixels.
const std::vector<KeptData>& kept_data();

/// Returns whether the files of a format can hold this kind of data.
bool keeps(std::string_view format, DataKind kind);

/// Returns whether the format is a picture for a display. The optics of the display determine where its views are seen from, so
/// a loss of cameras in one plane is not reported.
bool is_for_displays(std::string_view format);

/// Returns whether the writer of a format uses depth: as maps, as points, or as bounds.
bool uses_depth(std::string_view format);

struct LostData {
  DataKind kind{};
  std::string description{};
};

/// Returns the data of a light field that the format cannot hold.
std::vector<LostData> lost_data(const LightField& field, std::string_view format);

}  // namespace lippmann
