// Writes the manual page in the macros of man(7), from the declarations of the commands.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "apps/lippmann/command_line.hpp"
#include "lippmann/core/version.hpp"

namespace lippmann::app {
namespace {

/// Escapes text for roff, so that dashes can be copied and no line starts with a roff request.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
      escaped += std::string("\\&") + c;
    else
      escaped += c;
  }
  return escaped;
}

/// CLI11 adds --help and --version to every command; the manual page explains them only once.
bool is_own(const CLI::Option& option) {
  return !option.check_lname("help") && !option.check_lname("help-all") && !option.check_lname("version");
}

std::string entry(const CLI::Option& option) {
  const bool takes_value = option.get_items_expected_max() > 0 && !option.get_type_name().empty();
  const std::string names = option.get_name(false, true);
  const std::string type =
      takes_value && !option.get_positional() ? fmt::format(" \\fI{}\\fR", plain(option.get_type_name())) : std::string();
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", plain(names), type, plain(option.get_description()));
}

std::string entries(const CLI::App& command) {
  std::string text;
  std::string heading = "Options";
  for (const CLI::Option* option : command.get_options()) {
    if (!is_own(*option) || option->get_group().empty()) continue;
    if (!option->get_positional() && option->get_group() != heading) {
      heading = option->get_group();
      text += fmt::format(".PP\n{}:\n", plain(heading));
    }
    text += entry(*option);
  }
  for (const CLI::App* group : command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); })) {
    text += fmt::format(".PP\n{}:\n", plain(group->get_group()));
    for (const CLI::Option* option : group->get_options())
      if (is_own(*option)) text += entry(*option);
  }
  return text;
}

}  // namespace

std::string CommandLine::manual() const {
  std::string text = fmt::format(
      ".TH LIPPMANN 1 \"\" \"lippmann {0}\" \"User Commands\"\n"
      ".SH NAME\nlippmann \\- {1}\n"
      ".SH SYNOPSIS\n.B lippmann\n.I COMMAND\n[\\fIargument\\fR | \\fIflag\\fR]...\n"
      ".PP\n.B lippmann help\n[\\fICOMMAND\\fR]\n"
      ".SH DESCRIPTION\n"
      "An integral image lies behind an array of lenses. Each lens shows a different pixel at every angle, so the image has "
      "depth without glasses. Every flag of \\fBlippmann render\\fR is a key of the same name in a job file.\n"
      ".SH OPTIONS\n",
      plain(version()), plain(app_->get_description()));
  for (const CLI::Option* option : app_->get_options()) text += entry(*option);
  text += ".SH COMMANDS\n";
  for (const CLI::App* command : app_->get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); }))
    text += fmt::format(".SS lippmann {}\n{}\n{}", plain(command->get_name()), plain(command->get_description()),
                        entries(*command));
  return text +
         ".SH EXIT STATUS\n"
         ".TP\n0\nDone.\n.TP\n1\nThe work failed: bad input, or a file that could not be read or written.\n"
         ".TP\n2\nWrong usage: the message says what would be accepted.\n.TP\n128 + n\nStopped by signal n.\n"
         ".SH EXAMPLES\n.nf\nlippmann render room \\-\\-frames 0\nlippmann view out/room\n.fi\n";
}

}  // namespace lippmann::app
