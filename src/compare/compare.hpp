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

/// Values of one frame. A value is empty if it was not requested or is undefined: for equal frames, a single view, or the first
/// frame.
struct FrameConsistency {
  std::string name;
  std::optional<double> angular_psnr_db = {}, flicker = {};
};

struct Comparison {
  std::vector<FrameComparison> frames;
  ChannelErrors mean_mse, mean_rmse;               ///< means over all frames
  std::optional<double> mean_psnr_db;              ///< over the frames that are not identical; none if all are
  std::optional<double> mean_ssim;                 ///< mean over the frames that have an SSIM
  bool identical = true;                           ///< whether all codes of all frames are equal
  std::vector<FrameConsistency> consistency = {};  ///< set if the metrics angular or flicker are requested
};

struct CompareParams {
  /// Numbers of the frames to compare, in ascending order: the numbers in file names, or the positions in a video. nullopt: all
  /// frames. Frames that are not listed may be missing; a missing frame of the list is an Error.
  std::optional<std::vector<int>> frames = {};
  MetricChoice choice = {};
  bool per_view = false;  ///< whether each view of a light field is compared separately, as a FrameComparison of its own
  ViewsHints hints = {};

  bool compares_views() const {
    return per_view || choice.angular || choice.flicker || !hints.from.empty() || hints.views || hints.tiles;
  }
};

/// Compares all frames. Frames of folders are matched by name without extension, and frames of videos by position. Throws Error
/// if a frame is missing or the sizes of two frames differ. Stops early, with the frames so far, if context.cancelled is set.
Comparison compare(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                   const CompareParams& params = {});

/// Returns a comparison with the means over `frames`.
Comparison summarise(std::vector<FrameComparison> frames);

}  // namespace lippmann
