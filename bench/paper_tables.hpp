// Makes the three tables of the paper, with the paper's figures beside ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// CPU milliseconds of tracing with the pixel-tracing styles. Each value is the median of five measurements. A style is the
/// order in which pixels are traced.
struct StyleRow {
  std::string scene;
  /// only the pixels below the first lens: traced in rows, and in columns
  double horizontal_lens_ms = 0.0, vertical_lens_ms = 0.0;
  /// the whole frame: traced in rows, in columns, and in tiles of a view
  double horizontal_ms = 0.0, vertical_ms = 0.0, view_ms = 0.0;
};

/// Returns the saving of an animation in table 2 of the paper, as a share of its seconds. Returns no value if the animation is
/// not in the table.
std::optional<double> papers_saving(const std::string& scene);
/// Returns the mean PSNR in dB that the paper states for an animation. The paper states it only for the teapot.
std::optional<double> papers_psnr_db(const std::string& scene);

/// Returns table 1: errors and PSNR of single frames. It contains the frames of the paper's table if the runs have them.
std::string table_1(const std::vector<ReuseRun>& runs);
/// Returns table 2: seconds, savings and PSNR of whole animations.
std::string table_2(const std::vector<ReuseRun>& runs);
/// Returns table 3: the times of the pixel-tracing styles.
std::string table_3(const std::vector<StyleRow>& rows);

}  // namespace lippmann::bench
