// The flags --json and --quiet, for commands whose results are files or an exit code.
#pragma once

#include "apps/lippmann/command_line.hpp"

namespace lippmann::app {

struct ResultFlags {
  bool json = false, quiet = false;
  bool wants_text() const { return !json && !quiet; }
};

inline void add_result_flags(const Command& command, ResultFlags& flags,
                             const char* quiet = "Print neither progress nor the result; warnings and errors remain") {
  command.add_flag("--json", flags.json, "Print the result as JSON on stdout");
  command.add_flag("-q,--quiet", flags.quiet, quiet);
}

}  // namespace lippmann::app
