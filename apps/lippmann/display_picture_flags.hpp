// Flags of `convert` for the picture that is shown on a display or printed behind its lenses.
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/display_picture.hpp"

namespace lippmann::app {

class Command;

struct DisplayPictureFlags {
  std::string fit, shares, icc;
  bool mirror = false, flip = false, marks = false, proof = false;
  std::optional<int> turn_deg;
  std::optional<double> blend, bleed_mm, view_shift_px;

  /// Throws a usage Error naming an invalid flag.
  DisplayPictureParams read(const InterlaceParams& interlace) const;
};

void add_display_picture_flags(const Command& command, DisplayPictureFlags& flags);

}  // namespace lippmann::app
