// Compares two images, two folders of frames, two videos, or a folder and a video. Frames are compared in pairs.
//
// image/metrics.hpp and docs/reference/metrics.md define all figures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/metric_choice.hpp"
#include "compare/views_of_frame.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann {

struct FrameComparison {
  std::string name;
  PictureMetrics metrics;
};

/// Consistency metrics of one frame. A value is empty if it was not requested or is undefined. It is undefined for equal
/// frames, for a single view, or for the first frame.
struct FrameConsistency {
  std::string name;
  std::optional<double> angular_psnr_db = {}, flicker = {};
};

struct Comparison {
  std::vector<FrameComparison> frames;
  ChannelErrors mean_mse, mean_rmse;  ///< means over all frames
  /// Mean over the frames that are not identical. nullopt if all frames are identical.
  std::optional<double> mean_psnr_db;
  std::optional<double> mean_ssim;                 ///< mean over the frames that have an SSIM
  bool identical = true;                           ///< whether all codes of all frames are equal
  std::vector<FrameConsistency> consistency = {};  ///< set if the metrics angular or flicker are requested
};

struct CompareParams {
  /// Numbers of the frames to compare, in ascending order. A frame's number is the number in its file name, or its position in
  /// a video. If nullopt, all frames are compared. Otherwise, frames that are not in the list may be missing, and a missing
  /// frame of the list is an Error.
  std::optional<std::vector<int>> frames = {};
  MetricChoice choice = {};
  /// Whether views of a light field are compared separately. Each view then has its own FrameComparison.
  bool per_view = false;
  ViewsHints hints = {};

  bool compares_views() const {
    return per_view || choice.angular || choice.flicker || !hints.from.empty() || hints.views || hints.tiles;
  }
};

/// Compares all frames. Frames of folders are matched by name without extension, and frames of videos by position. Throws Error
/// if a frame is missing or if the sizes of two frames differ. If context.cancelled is set, stops early and returns the frames
/// compared so far.
Comparison compare(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                   const CompareParams& params = {});

/// Returns a comparison that holds `frames` and their means.
Comparison summarise(std::vector<FrameComparison> frames);

}  // namespace lippmann
