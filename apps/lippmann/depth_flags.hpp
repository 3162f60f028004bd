// Flags of `convert` for RGB-D pictures.
#pragma once

#include <optional>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/formats/formats.hpp"
#include "replay/depth_frames.hpp"

namespace lippmann::app {

class Command;
struct ResultFlags;

struct DepthFlags {
  std::string range, coding, map;
  bool near_black = false;
  std::optional<double> scale;

  void add_to(FormatOptions& options) const;
};

void add_depth_flags(const Command& command, DepthFlags& flags);

/// Converts RGB-D pictures to views, and prints the share of pixels that were filled.
int run_depth_views(const DepthConversion& params, const ResultFlags& result, const Context& context);

}  // namespace lippmann::app
