// `lippmann manual`: prints the manual page in the format of man(1). The build writes it to a file; --help does not list it.
#include <fmt/core.h>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"

namespace lippmann::app {

void add_manual_command(const Command& root, Action& chosen, const CommandLine& command_line) {
  const Command command = root.add_command("manual", "Print the manual page for man");
  command.hide();
  command.when_named([&chosen, &command_line] {
    chosen = [&command_line](Context&) {
      fmt::print("{}", command_line.manual());
      return 0;
    };
  });
}

}  // namespace lippmann::app
