// Writes docs/reference/command-line.md from the declarations of the commands.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <utility>

#include "apps/lippmann/command_line.hpp"

namespace lippmann::app {
namespace {

/// Returns the name of an option's value, or the words that the option accepts. Leaves out checks whose text depends on the
/// version of CLI11.
std::string type_in_reference(const CLI::Option& option) {
  std::string type = option.get_type_name();
  if (const std::size_t words = type.find(":{"); words != std::string::npos) {
    type = type.substr(words + 2, type.find('}', words) - words - 2);
    std::replace(type.begin(), type.end(), ',', '|');
  }
  const std::size_t range = type.find(" in [");
  const std::size_t check = range != std::string::npos ? type.rfind(':', range) : type.find(":POSITIVE");
  return type.substr(0, std::min(check, type.find(":NONNEGATIVE")));
}

std::string reference_entry(const CLI::Option& option) {
  const bool takes_value = option.get_items_expected_max() > 0 && !option.get_type_name().empty();
  const std::string name = option.get_name(option.get_positional(), true);
  const std::string type = takes_value && !option.get_positional() ? " " + type_in_reference(option) : std::string();
  return fmt::format("- `{}{}`: {}\n", name, type, option.get_description());
}

bool is_in_reference(const CLI::Option& option) {
  return !option.check_lname("help") && !option.check_lname("help-all") && !option.get_group().empty();
}

/// The options below one heading. An option that an earlier command has already described is listed by its name only.
class ReferenceGroup {
 public:
  ReferenceGroup(std::string heading, std::string command) : heading_(std::move(heading)), command_(std::move(command)) {}

  void add(const CLI::Option& option, std::map<std::string, std::string>& command_of_entry) {
    const std::string entry = reference_entry(option);
    const auto [found, is_new] = command_of_entry.emplace(entry, command_);
    if (is_new) {
      entries_ += entry;
      return;
    }
    std::string& names = repeated_[found->second];
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", option.get_name());
  }

  std::string text() const {
    if (entries_.empty() && repeated_.size() == 1) return fmt::format("{}: see `{}`.\n\n", heading_, repeated_.begin()->first);
    std::string text = fmt::format("{}:\n\n{}", heading_, entries_);
    for (const auto& [command, names] : repeated_) text += fmt::format("- {}: see `{}`\n", names, command);
    return entries_.empty() && repeated_.empty() ? std::string() : text + "\n";
  }

 private:
  std::string heading_, command_, entries_;
  std::map<std::string, std::string> repeated_;
};

std::string reference_of(const CLI::App& command, std::map<std::string, std::string>& command_of_entry) {
  std::vector<ReferenceGroup> groups;
  std::map<std::string, std::size_t> group_of_heading;
  const auto add = [&](const std::string& heading, const CLI::Option& option) {
    if (!is_in_reference(option)) return;
    const auto [found, is_new] = group_of_heading.emplace(heading, groups.size());
    if (is_new) groups.emplace_back(heading, command.get_name());
    groups[found->second].add(option, command_of_entry);
  };
  for (const CLI::Option* option : command.get_options())
    add(option->get_positional() ? "Arguments" : option->get_group(), *option);
  for (const CLI::App* group : command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); }))
    for (const CLI::Option* option : group->get_options()) add(group->get_group(), *option);
  std::string text = fmt::format("## {}\n\n{}.\n\n", command.get_name(), command.get_description());
  for (const ReferenceGroup& group : groups) text += group.text();
  return text;
}

}  // namespace

std::string CommandLine::reference() const {
  std::string text =
      "# Command line\n\n"
      "`lippmann manual --markdown` prints this page, `lippmann COMMAND --help` the part of one command, with examples and "
      "the\n"
      "ranges of numbers. The exit code is 0 when done, 1 if the work failed, 2 for wrong usage, and 128 + n after signal n.\n"
      "Messages and progress go to stderr; with `--json`, stdout has nothing but JSON. Each flag of `render` is a key of the\n"
      "same name in a [job file](formats.md#jobs-jobtoml).\n\n";
  std::map<std::string, std::string> command_of_entry;
  for (const CLI::App* command : app_->get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); }))
    text += reference_of(*command, command_of_entry);
  text.pop_back();
  return text;
}

}  // namespace lippmann::app
