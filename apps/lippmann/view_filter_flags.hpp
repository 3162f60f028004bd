// Flags that choose how pixels of a slanted panel interpolate between neighbouring views.
#pragma once

#include <string>

#include "lippmann/layout/interlace.hpp"

namespace lippmann::app {

class Command;

struct ViewFilterFlags {
  std::string filter;
  double sigma = 0.0;

  InterlaceParams read() const;
};

/// of: text at the end of the help of --filter.
void add_view_filter_flags(const Command& command, ViewFilterFlags& flags, const std::string& of);

}  // namespace lippmann::app
