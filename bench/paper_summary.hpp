// What of the paper is reproduced: for each of its animations, what it saves and how near its pictures are beside ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// One animation. The paper does not say how many frames lie between its key frames: ours is the shortest interval that saves
/// as much as the paper does, or else the one that saves most.
struct Reproduced {
  std::string scene;
  int keyframes = 0;
  double saving = 0.0;                       ///< the share of full tracing's CPU seconds that is saved, key frames included
  std::optional<double> psnr_db = {};        ///< mean of the frames in between
  std::optional<double> paper_saving = {};   ///< none: the paper has no such animation
  std::optional<double> paper_psnr_db = {};  ///< none: the paper states none for it

  /// "yes", "no", or "not in the paper".
  std::string verdict() const;
};

/// The figures of the best run without halving for each scene, in the order of the runs.
std::vector<Reproduced> reproduced_figures(const std::vector<ReuseRun>& runs);

/// One sentence, and one line per animation.
std::string reproduced_text(const std::vector<Reproduced>& rows);

/// With a line of names; empty cells where there is no figure.
std::string reproduced_csv(const std::vector<Reproduced>& rows);

}  // namespace lippmann::bench
