#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/reuse_run.hpp"

namespace lippmann::bench {

/// The paper does not state the interval between its key frames. We use the shortest interval that saves as much as the paper.
/// If no interval does, we use the interval that saves most.
struct Reproduced {
  std::string scene;
  int keyframes = 0;
  double saving = 0.0;
  std::optional<double> psnr_db = {};
  std::optional<double> paper_saving = {};
  std::optional<double> paper_psnr_db = {};

  std::string verdict() const;
};

std::vector<Reproduced> reproduced_figures(const std::vector<ReuseRun>& runs);

std::string reproduced_text(const std::vector<Reproduced>& rows);

std::string reproduced_csv(const std::vector<Reproduced>& rows);

}  // namespace lippmann::bench
