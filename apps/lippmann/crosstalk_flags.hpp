// Flags of `convert` for pictures that undo a display's crosstalk.
#pragma once

#include <string>

#include "lippmann/core/context.hpp"

namespace lippmann::app {

class Command;       // command_line.hpp
struct ResultFlags;  // result_flags.hpp

struct CrosstalkFlags {
  bool precompensate = false;
  std::string crosstalk;
};

void add_crosstalk_flags(const Command& command, CrosstalkFlags& flags);

/// `convert --precompensate`: converts, and prints the bound. `display`: whose own frames the pictures are; empty: as the
/// report.json beside them says.
int run_precompensate(const CrosstalkFlags& flags, const std::string& display, const std::string& in, const std::string& out,
                      const ResultFlags& result, const Context& context);

/// How near to the wanted pictures an eye sees them.
std::string describe_bound(double clipped_share, double largest_residual);

}  // namespace lippmann::app
