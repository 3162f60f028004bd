#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// CPU milliseconds of tracing, the median of five measurements, for several orders of the pixels.
struct StyleRow {
  std::string scene;
  /// only the pixels below the first lens: traced in rows, and in columns
  double horizontal_lens_ms = 0.0, vertical_lens_ms = 0.0;
  /// the whole frame: traced in rows, in columns, and in tiles of a view
  double horizontal_ms = 0.0, vertical_ms = 0.0, view_ms = 0.0;
};

std::optional<double> papers_saving(const std::string& scene);
std::optional<double> papers_psnr_db(const std::string& scene);

std::string table_1(const std::vector<ReuseRun>& runs);
std::string table_2(const std::vector<ReuseRun>& runs);
std::string table_3(const std::vector<StyleRow>& rows);

}  // namespace lippmann::bench
