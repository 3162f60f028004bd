// Compares two pictures, two folders of frames, or two videos (or a folder and a video) frame by frame.
//
// Definitions of all figures: image/metrics.hpp and docs/reference/metrics.md.
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

/// Values of one frame; empty if not chosen or without a value (of equal frames, of a single view, of the first frame).
struct FrameConsistency {
  std::string name;
  std::optional<double> angular_psnr_db = {}, flicker = {};
};

struct Comparison {
  std::vector<FrameComparison> frames;
  ChannelErrors mean_mse, mean_rmse;               ///< means over all frames
  std::optional<double> mean_psnr_db;              ///< over the frames that are not identical; none if all are
  std::optional<double> mean_ssim;                 ///< over the frames that have one
  bool identical = true;                           ///< every code of every frame
  std::vector<FrameConsistency> consistency = {};  ///< where the choice has angular or flicker
};

struct CompareParams {
  /// The numbers of the frames to compare, ascending: those of files' names, of a video their order; none: all. Frames that are
  /// not wanted may be missing; Error where a wanted one is.
  std::optional<std::vector<int>> frames = {};
  MetricChoice choice = {};
  bool per_view = false;  ///< each view of a light field is compared by itself and is a FrameComparison
  ViewsHints hints = {};

  bool compares_views() const {
    return per_view || choice.angular || choice.flicker || !hints.from.empty() || hints.views || hints.tiles;
  }
};

/// Frames of folders are matched by name (the extensions may differ); those of videos by their order. Throws Error that says
/// which frame is missing, or differs in size. Stops early, with the frames so far, when context.cancelled is set.
Comparison compare(const std::filesystem::path& reference, const std::filesystem::path& test, const Context& context,
                   const CompareParams& params = {});

/// The means of frames that have been compared.
Comparison summarise(std::vector<FrameComparison> frames);

}  // namespace lippmann
