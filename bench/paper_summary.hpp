// Compares our savings and PSNR with those of the paper, for each animation of the paper.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// The comparison for one animation. The paper does not state the interval between its key frames. We use the shortest interval
/// that saves as much as the paper. If there is none, we use the interval that saves most.
struct Reproduced {
  std::string scene;
  int keyframes = 0;
  double saving = 0.0;                       ///< saved share of the CPU seconds of full tracing, including key frames
  std::optional<double> psnr_db = {};        ///< mean PSNR of the in-between frames
  std::optional<double> paper_saving = {};   ///< no value if the animation is not in the paper
  std::optional<double> paper_psnr_db = {};  ///< no value if the paper does not state it

  /// Returns "yes", "no", or "not in the paper".
  std::string verdict() const;
};

/// Returns the figures of the best run of each scene, in the order of the runs. Runs with halving are left out.
std::vector<Reproduced> reproduced_figures(const std::vector<ReuseRun>& runs);

/// Returns a sentence, and one line for each animation.
std::string reproduced_text(const std::vector<Reproduced>& rows);

/// Returns CSV text with a header line. Missing figures are empty cells.
std::string reproduced_csv(const std::vector<Reproduced>& rows);

}  // namespace lippmann::bench
