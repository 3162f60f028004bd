#include "apps/lippmann/command_line.hpp"

#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "apps/lippmann/print.hpp"
#include "core/suggest.hpp"
#include "job/params_table.hpp"
#include "job/removed_params.hpp"

namespace lippmann::app {
namespace {

/// Returns ", did you mean '...'?" with the flag or command most similar to an unknown word; empty if none is similar.
std::string suggestion(const std::string& word, const CLI::App& command) {
  std::vector<std::string> names;
  if (word.starts_with("-")) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back(name);
  } else {
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); }))
      names.push_back(sub->get_name());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  // Compare names without dashes, because leading dashes would make any two short flags similar.
  const std::string_view dashes = word.starts_with("-") ? "--" : "";
  const std::string name = word.substr(std::min(word.find_first_not_of('-'), word.size()));
  const std::string flag = name.substr(0, name.find('='));
  const bool is_packing = flag == "lens-arrangement" && std::ranges::find(names, "packing") != names.end();  // convert's name
  const std::string nearest = is_packing ? "packing" : nearest_name(flag, candidates);
  return nearest.empty() ? std::string() : fmt::format(", did you mean '{}{}'?", dashes, nearest);
}

class ShortHelp : public CLI::Formatter {
 public:
  ShortHelp(std::vector<std::string> flags, std::string examples) : flags_(std::move(flags)), examples_(std::move(examples)) {}

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return CLI::Formatter::make_help(app, std::move(name), mode);
    std::string text = make_description(app) + make_usage(app, std::move(name)) + "\n" + examples_ + make_positionals(app);
    if (mode == CLI::AppFormatMode::All) return text + make_groups(app, mode) + make_subcommands(app, mode);
    text +=
        make_group("Common options", false, app->get_options([this](const CLI::Option* option) { return is_common(*option); }));
    return text + "\nAll options, by group: --help-all\n";
  }

 private:
  bool is_common(const CLI::Option& option) const {
    for (const std::string& name : option.get_lnames())
      if (std::find(flags_.begin(), flags_.end(), "--" + name) != flags_.end()) return true;
    return false;
  }

  std::vector<std::string> flags_;
  std::string examples_;
};

const CLI::App* command_named(const std::string& name, const CLI::App& root) {
  const auto found = root.get_subcommands([&](const CLI::App* command) { return command->get_name() == name; });
  return found.empty() ? nullptr : found.front();
}

int refuse(const CLI::App& root, const std::string& word) {
  print_error("{}: there is no '{}'{} (see {} --help)\n", root.get_name(), word, suggestion(word, root), root.get_name());
  return kWrongUsage;
}

std::vector<std::string> help_words(std::vector<std::string> words) {
  if (words.empty() || words.front() != "help") return words;
  if (words.size() == 1 || words[1] == "help") return {"--help"};
  return {words[1], words.size() > 2 ? words[2] : "--help"};
}

/// Adds the default value to flags that may be given without a value: "--denoise" becomes "--denoise=auto".
std::vector<std::string> with_bare_values(std::vector<std::string> words, const CLI::App& root) {
  const CLI::App* command = words.empty() ? nullptr : command_named(words.front(), root);
  for (std::size_t i = 1; command && i < words.size(); ++i) {
    if (!words[i].starts_with("--")) continue;
    const ParamInfo* info = find_param(std::string_view(words[i]).substr(2));
    const CLI::Option* option = info && !info->bare_value.empty() ? command->get_option_no_throw(words[i]) : nullptr;
    if (!option || option->get_items_expected_max() == 0) continue;
    const bool has_value =
        i + 1 < words.size() && std::find(info->choices.begin(), info->choices.end(), words[i + 1]) != info->choices.end();
    if (!has_value) words[i] += fmt::format("={}", info->bare_value);
  }
  return words;
}

/// Prints help and the version on stdout (exit code 0), and anything else as an error on stderr (exit code 2).
int report(const CLI::ParseError& outcome, const CLI::App& root) {
  if (outcome.get_exit_code() == 0) return root.exit(outcome);
  const CLI::App* command = &root;
  std::string name = root.get_name();
  for (const CLI::App* chosen : root.get_subcommands()) command = chosen, name += " " + chosen->get_name();
  std::string problem = outcome.what();
  for (const std::string& word : root.remaining(true)) {
    if (!word.starts_with("-") && command != &root) continue;
    const std::string flag = word.substr(0, word.find('='));
    const auto removed = flag.starts_with("--") ? removal_of(flag.substr(2), "", flag) : std::nullopt;
    problem = removed ? removed->what() : fmt::format("there is no '{}'{}", word, suggestion(word, *command));
    break;
  }
  print_error("{}: {} (see {} --help)\n", name, problem, name);
  return kWrongUsage;
}

}  // namespace

std::string with_flags(std::string_view text) {
  constexpr std::string_view kOfNames = "abcdefghijklmnopqrstuvwxyz-";
  std::string worded;
  while (!text.empty()) {
    const std::size_t open = text.find('`');
    worded += text.substr(0, open);
    if (open == text.npos) break;
    text.remove_prefix(open + 1);
    const std::size_t end = text.find_first_not_of(kOfNames);
    const bool is_name = end != text.npos && end > 0 && text[end] == '`';
    worded += is_name ? fmt::format("--{}", text.substr(0, end)) : "`";
    if (is_name) text.remove_prefix(end + 1);
  }
  return worded;
}

const Flag& Flag::required() const { return option_->required(), *this; }
const Flag& Flag::type_name(const std::string& name) const { return option_->type_name(name), *this; }
const Flag& Flag::group(const std::string& heading) const { return option_->group(heading), *this; }
const Flag& Flag::values(int count, char delimiter) const { return option_->delimiter(delimiter)->expected(count), *this; }
const Flag& Flag::single() const { return option_->expected(1), *this; }
const Flag& Flag::one_word_each() const { return option_->allow_extra_args(false), *this; }
const Flag& Flag::range(int least, int most) const { return option_->check(CLI::Range(least, most)), *this; }
const Flag& Flag::range(double least, double most) const {
  // CLI::Range accepts NaN.
  const auto problem = [least, most](const std::string& text) {
    const bool is_nan = std::isnan(std::strtod(text.c_str(), nullptr));
    return is_nan ? fmt::format("Value {} not in range [{} - {}]", text, least, most) : std::string();
  };
  option_->check(CLI::Validator(problem, ""));
  return option_->check(CLI::Range(least, most)), *this;
}
const Flag& Flag::positive() const { return option_->check(CLI::PositiveNumber), *this; }
const Flag& Flag::not_negative() const { return option_->check(CLI::NonNegativeNumber), *this; }

const Flag& Flag::one_of(std::initializer_list<const char*> words) const {
  const std::vector<std::string_view> known(words.begin(), words.end());
  const auto problem = [known](const std::string& word) {
    if (std::find(known.begin(), known.end(), word) != known.end()) return std::string();
    return fmt::format("there is no '{}'{}; accepted: {}", word, did_you_mean(word, known), fmt::join(known, ", "));
  };
  return option_->check(CLI::Validator(problem, fmt::format("{{{}}}", fmt::join(known, ",")))), *this;
}

bool Flag::given() const { return option_->count() > 0; }
const Flag& Flag::show_default() const { return option_->capture_default_str(), *this; }

Command Command::add_command(const std::string& name, const std::string& doc) const {
  return Command(*app_->add_subcommand(name, doc));
}

Command Command::add_group(const std::string& heading, const std::string& doc) const {
  return Command(*app_->add_option_group(heading, doc));
}

template <typename Value>
Flag Command::add_option(const std::string& names, Value& value, const std::string& doc) const {
  return Flag(*app_->add_option(names, value, doc));
}

template Flag Command::add_option(const std::string&, std::string&, const std::string&) const;
template Flag Command::add_option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Flag Command::add_option(const std::string&, int&, const std::string&) const;
template Flag Command::add_option(const std::string&, std::optional<int>&, const std::string&) const;
template Flag Command::add_option(const std::string&, double&, const std::string&) const;
template Flag Command::add_option(const std::string&, std::optional<double>&, const std::string&) const;
template Flag Command::add_option(const std::string&, std::vector<double>&, const std::string&) const;

Flag Command::add_flag(const std::string& names, bool& value, const std::string& doc) const {
  return Flag(*app_->add_flag(names, value, doc));
}

Flag Command::add_flag(const std::string& names, std::function<void()> when_given, const std::string& doc) const {
  return Flag(*app_->add_flag_callback(names, std::move(when_given), doc));
}

void Command::footer(const std::string& text) const { app_->footer(text); }
void Command::hide() const { app_->group(""); }

void Command::short_help(std::vector<std::string> flags, std::string examples) const {
  app_->set_help_all_flag("--help-all", "Print all options and exit");
  app_->formatter(std::make_shared<ShortHelp>(std::move(flags), std::move(examples)));
}

void Command::when_named(std::function<void()> then) const { app_->callback(std::move(then)); }

CommandLine::CommandLine(const std::string& name, const std::string& doc, const std::string& version)
    : app_(std::make_unique<CLI::App>(doc, name)) {
  app_->set_version_flag("-v,-V,--version", version, "Print the version and exit");
  app_->set_help_flag("-h,--help", "Print this help and exit");
  app_->require_subcommand(1);
  app_->footer("lippmann help COMMAND, or lippmann COMMAND --help, explains a command.");
}

CommandLine::~CommandLine() = default;

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool about_command = words.size() > 1 && words.front() == "help" && words[1] != "help";
    if (about_command && !command_named(words[1], *app_)) return refuse(*app_, words[1]);
    words = with_bare_values(help_words(words), *app_);
    std::reverse(words.begin(), words.end());  // CLI11 expects the words in reverse order
    app_->parse(std::move(words));
  } catch (const CLI::ParseError& outcome) {
    return report(outcome, *app_);
  }
  return std::nullopt;
}

std::string CommandLine::message_of(const Error& error) const {
  const std::string flag = "--" + error.where();
  const std::vector<CLI::App*> commands = app_->get_subcommands([](CLI::App*) { return true; });
  const bool is_flag = error.kind() == ErrorKind::kUsage &&
                       std::any_of(commands.begin(), commands.end(),
                                   [&](CLI::App* command) { return command->get_option_no_throw(flag) != nullptr; });
  return (is_flag ? "--" : "") + with_flags(error.what());
}

}  // namespace lippmann::app
