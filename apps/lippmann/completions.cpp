#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "apps/lippmann/command_line.hpp"

namespace lippmann::app {
namespace {

using Names = std::vector<std::string>;

Names beginning_with(const std::string& start, const Names& names) {
  Names found;
  std::copy_if(names.begin(), names.end(), std::back_inserter(found),
               [&](const auto& name) { return name.starts_with(start); });
  return found;
}

/// CLI11 stores groups of flags as commands without a name.
bool is_listed(const CLI::App& command) { return !command.get_name().empty() && !command.get_group().empty(); }

Names commands_of(const CLI::App& root) {
  Names names{"help"};
  for (const CLI::App* command : root.get_subcommands([](const CLI::App* app) { return is_listed(*app); }))
    names.push_back(command->get_name());
  return names;
}

const CLI::App* find_command(const CLI::App& root, const std::string& name) {
  for (const CLI::App* command : root.get_subcommands([](const CLI::App*) { return true; }))
    if (command->get_name() == name) return command;
  return nullptr;
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::App* group : command.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); }))
    for (const CLI::Option* option : group->get_options()) options.push_back(option);
  return options;
}

Names flags_of(const CLI::App& command) {
  std::set<std::string> flags;
  for (const CLI::Option* option : options_of(command))
    for (const std::string& name : option->get_lnames()) flags.insert("--" + name);
  return {flags.begin(), flags.end()};
}

/// Returns the flag that `word` names if the next word is its value; otherwise null.
const CLI::Option* flag_before(const CLI::App& command, const std::string& word) {
  for (const CLI::Option* option : options_of(command))
    if (word.starts_with("-") && option->check_name(word)) return option->get_items_expected_max() > 0 ? option : nullptr;
  return nullptr;
}

Names words_in_braces(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  Names words;
  if (open == type.npos || close == type.npos || close < open) return words;
  for (std::size_t start = open + 1; start < close;) {
    const std::size_t end = std::min(type.find(',', start), close);
    words.push_back(type.substr(start, end - start));
    start = end + 1;
  }
  return words;
}

}  // namespace

std::vector<std::string> CommandLine::completions(const std::vector<std::string>& words, const ValuesOf& values_of) const {
  const Names files{":files"};
  if (words.size() < 2) return beginning_with(words.empty() ? "" : words.back(), commands_of(*app_));
  if (words.front() == "help") return beginning_with(words.back(), commands_of(*app_));
  const CLI::App* command = find_command(*app_, words.front());
  if (!command) return {};
  const std::string& word = words.back();
  if (const CLI::Option* flag = flag_before(*command, words[words.size() - 2])) {
    Names known = words_in_braces(flag->get_type_name());
    if (known.empty() && !flag->get_lnames().empty()) known = values_of(flag->get_lnames().front());
    return known.empty() ? files : beginning_with(word, known);
  }
  if (word.starts_with("-")) return beginning_with(word, flags_of(*command));
  Names found;
  for (const CLI::Option* option : command->get_options())
    if (option->get_positional() && option->get_lnames().empty())
      found = beginning_with(word, values_of(option->get_single_name()));
  found.insert(found.end(), files.begin(), files.end());
  return found;
}

}  // namespace lippmann::app
