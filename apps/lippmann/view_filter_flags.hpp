// Flags that say how views are mixed where a slanted panel's frame is made of them.
#pragma once

#include <string>

#include "lippmann/layout/interlace.hpp"

namespace lippmann::app {

class Command;  // command_line.hpp

struct ViewFilterFlags {
  std::string filter;
  double sigma = 0.0;

  InterlaceParams read() const;
};

/// `of`: what they are for, to end the help of --filter with.
void add_view_filter_flags(const Command& command, ViewFilterFlags& flags, const std::string& of);

}  // namespace lippmann::app
