// Compares our savings and PSNR with the paper's for each of its animations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// The comparison for one animation. The paper does not state the interval between its key frames, so we use the shortest
/// interval that saves as much as the paper, or else the interval that saves most.
struct Reproduced {
  std::string scene;
  int keyframes = 0;
  double saving = 0.0;                       ///< saved share of full tracing's CPU seconds, key frames included
  std::optional<double> psnr_db = {};        ///< mean PSNR of the in-between frames
  std::optional<double> paper_saving = {};   ///< no value: the paper has no such animation
  std::optional<double> paper_psnr_db = {};  ///< no value: the paper states none

  /// Returns "yes", "no", or "not in the paper".
  std::string verdict() const;
};

/// Returns the figures of the best run without halving for each scene, in the order of the runs.
std::vector<Reproduced> reproduced_figures(const std::vector<ReuseRun>& runs);

/// Returns one sentence, and one line per animation.
std::string reproduced_text(const std::vector<Reproduced>& rows);

/// Returns CSV with a header line; missing figures are empty cells.
std::string reproduced_csv(const std::vector<Reproduced>& rows);

}  // namespace lippmann::bench
