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

/// A value is empty if it was not requested, or if it is undefined, as for equal frames, for a single view, and for the flicker
/// of the first frame.
struct FrameConsistency {
  std::string name;
  std::optional<double> angular_psnr_db = {}, flicker = {};
};

struct Comparison {
  std::vector<FrameComparison> frames;
  ChannelErrors mean_mse, mean_rmse;
  /// Mean over the frames that differ. nullopt if all frames are identical.
  std::optional<double> mean_psnr_db;
  std::optional<double> mean_ssim;  ///< mean over the frames that have an SSIM
  bool identical = true;
  std::vector<FrameConsistency> consistency = {};
};

struct CompareParams {
  /// Numbers of the frames to compare, ascending: the number in the file name, or the position in a video. nullopt: all frames.
  /// A frame in this list that is missing is an Error.
  std::optional<std::vector<int>> frames = {};
  MetricChoice choice = {};
  /// Compares each view of a light field separately.
  bool per_view = false;
  ViewsHints hints = {};

  bool compares_views() const {
    return per_view || choice.angular || choice.flicker || !hints.from.empty() || hints.views || hints.tiles;
  }
};

/// Matches frames of folders by name without extension, and frames of videos by position. Throws Error if a frame is missing or
/// if sizes differ. If context.cancelled is set, returns the frames compared so far.
Comparison compare(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                   const CompareParams& params = {});

Comparison summarise(std::vector<FrameComparison> frames);

}  // namespace lippmann
