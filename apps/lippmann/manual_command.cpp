// `lippmann manual`: prints the manual page for man(1). With --markdown, prints docs/reference/command-line.md.
#include <fmt/core.h>

#include <memory>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"

namespace lippmann::app {

void add_manual_command(const Command& root, Action& chosen, const CommandLine& command_line) {
  const Command command = root.add_command("manual", "Print the manual page for man");
  command.hide();
  const auto in_markdown = std::make_shared<bool>(false);
  command.add_flag("--markdown", *in_markdown, "Print docs/reference/command-line.md instead");
  command.when_named([&chosen, &command_line, in_markdown] {
    chosen = [&command_line, in_markdown](Context&) {
      fmt::print("{}", *in_markdown ? command_line.reference() : command_line.manual());
      return 0;
    };
  });
}

}  // namespace lippmann::app
