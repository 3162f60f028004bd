// Compares two images, two folders of frames, or two videos (or a folder and a video) frame by frame.
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

/// Values of one frame. Empty if not requested or undefined: equal frames, a single view, or the first frame.
struct FrameConsistency {
  std::string name;
  std::optional<double> angular_psnr_db = {}, flicker = {};
};

struct Comparison {
  std::vector<FrameComparison> frames;
  ChannelErrors mean_mse, mean_rmse;               ///< means over all frames
  std::optional<double> mean_psnr_db;              ///< over the frames that are not identical; none if all are
  std::optional<double> mean_ssim;                 ///< over the frames that have a value
  bool identical = true;                           ///< all codes of all frames are equal
  std::vector<FrameConsistency> consistency = {};  ///< set if angular or flicker is requested
};

struct CompareParams {
  /// Numbers of the frames to compare, in ascending order: numbers in file names, or positions in a video. none: all. Other
  /// frames may be missing; a missing frame of the list is an Error.
  std::optional<std::vector<int>> frames = {};
  MetricChoice choice = {};
  bool per_view = false;  ///< compare each view of a light field separately, as a FrameComparison of its own
  ViewsHints hints = {};

  bool compares_views() const {
    return per_view || choice.angular || choice.flicker || !hints.from.empty() || hints.views || hints.tiles;
  }
};

/// Compares all frames. Matches frames of folders by name without extension, and frames of videos by order. Throws Error if a
/// frame is missing or differs in size. Stops early, with the frames so far, if context.cancelled is set.
Comparison compare(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                   const CompareParams& params = {});

/// Returns the means of frames that were compared.
Comparison summarise(std::vector<FrameComparison> frames);

}  // namespace lippmann
