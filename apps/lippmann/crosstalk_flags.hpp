// Flags of `convert` for pictures that compensate a display's crosstalk.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"

namespace lippmann::app {

class Command;
struct ResultFlags;

struct CrosstalkFlags {
  bool precompensate = false;
  std::string crosstalk;
};

void add_crosstalk_flags(const Command& command, CrosstalkFlags& flags);

/// Runs `convert --precompensate` and prints the remaining error. `display` is the display for which the pictures were made. If
/// `display` is empty, the report.json beside the pictures states it.
int run_precompensate(const CrosstalkFlags& flags, const std::string& display, const std::string& in, const std::string& out,
                      const ResultFlags& result, const Context& context);

std::string describe_bound(double clipped_share, double largest_residual);

}  // namespace lippmann::app
