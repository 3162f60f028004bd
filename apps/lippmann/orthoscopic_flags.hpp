// The flags of `lippmann convert` that invert depth, and the conversion that they run.
#pragma once

#include <optional>
#include <string>

#include "lippmann/core/context.hpp"

namespace lippmann::app {

class Command;
struct ResultFlags;

struct OrthoscopicFlags {
  bool rotate_elemental = false;
  std::optional<double> spoc_mm, reference_mm, lens_pitch_mm, gap_mm;
  std::optional<int> lens_pixels;

  bool are_given() const { return rotate_elemental || spoc_mm; }
};

void add_orthoscopic_flags(const Command& command, OrthoscopicFlags& flags);

/// Runs the selected conversion and prints the written files. Requires at least one of the flags.
int run_orthoscopic(const OrthoscopicFlags& flags, const std::string& in, const std::string& out, const ResultFlags& result,
                    const Context& context);

}  // namespace lippmann::app
