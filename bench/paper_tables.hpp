// The paper's three tables, its figures beside ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// CPU milliseconds of tracing in one pixel-tracing style (median of five).
struct StyleRow {
  std::string scene;
  double horizontal_lens_ms = 0.0, vertical_lens_ms = 0.0;       ///< the first lens only: rows; columns
  double horizontal_ms = 0.0, vertical_ms = 0.0, view_ms = 0.0;  ///< the whole frame: rows; columns; tiles of a view
};

/// What table 2 of the paper saves of an animation, a fraction of its seconds; none: the scene is not in it.
std::optional<double> papers_saving(const std::string& scene);
/// The mean PSNR that the paper states of an animation; none of all but the teapot.
std::optional<double> papers_psnr_db(const std::string& scene);

/// Errors and PSNR of single frames: those that the paper lists where the runs have them.
std::string table_1(const std::vector<ReuseRun>& runs);
/// Seconds and savings of whole animations, and their likeness.
std::string table_2(const std::vector<ReuseRun>& runs);
/// Pixel-tracing styles.
std::string table_3(const std::vector<StyleRow>& rows);

}  // namespace lippmann::bench
