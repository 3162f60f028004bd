// The rows of `lippmann bench light`: what each renders, and the bars that it has to clear.
//
// Quiet rows are built-in scenes as animations, and as still quilts where their names end in -quilt; a file makes such rows,
// too. Hostile rows are those of hostile_scenes.hpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/light_run.hpp"

namespace lippmann::bench {

/// What is asked of a row.
struct LightBar {
  double saving = 0.0;                       ///< the share of CPU time saved, at least
  std::optional<double> gain_db;             ///< PSNR over the full render's, at least
  std::optional<double> equal_time_gain_db;  ///< PSNR over that of a full render of the same time, at least
  std::optional<double> block_gain_db;       ///< as gain_db, of block means
  std::optional<double> mean_light;  ///< share by which it differs from the reference's and from the full render's, at most
};

inline constexpr double kMemoryBar = 300e6;  ///< bytes beyond a full render, of pictures of
inline constexpr int kMemoryBarPixels = 512 * 512;

/// Those that the request names, or all quiet and hostile ones. Throws a usage Error for a name that is none, which lists them.
std::vector<LightCase> light_cases(const Request& request, const Context& context);

/// None is asked of scenes of the user's own.
std::optional<LightBar> light_bar(const std::string& row);

/// One line each, for people.
std::string light_row_list();

}  // namespace lippmann::bench
