// Prints the paper's three tables, with the paper's figures beside ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// CPU milliseconds of tracing in one pixel-tracing style (median of five).
struct StyleRow {
  std::string scene;
  double horizontal_lens_ms = 0.0, vertical_lens_ms = 0.0;       ///< only the first lens: rows; columns
  double horizontal_ms = 0.0, vertical_ms = 0.0, view_ms = 0.0;  ///< the whole frame: rows; columns; tiles of a view
};

/// Returns the saving of an animation in table 2 of the paper, as a fraction of its seconds; no value if the scene is missing.
std::optional<double> papers_saving(const std::string& scene);
/// Returns the mean PSNR that the paper states for an animation; no value except for the teapot.
std::optional<double> papers_psnr_db(const std::string& scene);

/// Returns table 1: errors and PSNR of single frames. These are the frames listed in the paper, if the runs have them.
std::string table_1(const std::vector<ReuseRun>& runs);
/// Returns table 2: seconds, savings and PSNR of whole animations.
std::string table_2(const std::vector<ReuseRun>& runs);
/// Returns table 3: the times of the pixel-tracing styles.
std::string table_3(const std::vector<StyleRow>& rows);

}  // namespace lippmann::bench
