// Flags of `convert` for stereo pictures.
#pragma once

#include <optional>
#include <string>

#include "lippmann/core/context.hpp"
#include "lippmann/layout/stereo.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann::app {

class Command;
struct ResultFlags;

struct StereoFlags {
  std::string packing;
  bool right_first = false;
  std::optional<double> ipd_mm, viewing_distance_mm, screen_width_mm, view_angle_deg;

  /// Returns the layout of the two views; nullopt if no flag is given.
  std::optional<StereoLayout> layout() const;
};

void add_stereo_flags(const Command& command, StereoFlags& flags);

/// Runs `convert --to stereo`, which computes what two eyes see of a light field. A light field of two views keeps its views.
int run_stereo(const StereoFlags& flags, const LightFieldHints& field, const std::string& in, const std::string& out,
               const ResultFlags& result, const Context& context);

}  // namespace lippmann::app
