// The paper's three tables, with its figures beside ours.
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

/// Errors and PSNR of single frames: those listed in the paper, if the runs have them.
std::string table_1(const std::vector<ReuseRun>& runs);
/// Seconds, savings and PSNR of whole animations.
std::string table_2(const std::vector<ReuseRun>& runs);
/// Pixel-tracing styles.
std::string table_3(const std::vector<StyleRow>& rows);

}  // namespace lippmann::bench
