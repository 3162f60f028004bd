#include "apps/lippmann/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <vector>

#include "core/suggest.hpp"

namespace lippmann::app {
namespace {

constexpr int kWrongUsage = 2;

/// What was meant by a word that nothing on the command line takes: the nearest flag of the command, or command.
std::string suggestion(const std::string& word, const CLI::App& command) {
  std::vector<std::string> names;
  if (word.starts_with("-")) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  } else {
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; })) names.push_back(sub->get_name());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::string nearest = nearest_name(word.substr(0, word.find('=')), candidates);
  return nearest.empty() ? std::string() : fmt::format(", did you mean '{}'?", nearest);
}

/// CLI11's own answer: help and version are results (stdout, 0), anything else is a message (stderr, 2).
int report(const CLI::ParseError& outcome, const CLI::App& root) {
  if (outcome.get_exit_code() == 0) return root.exit(outcome);
  const CLI::App* command = &root;
  std::string name = root.get_name();
  for (const CLI::App* chosen : root.get_subcommands()) command = chosen, name += " " + chosen->get_name();
  std::string problem = outcome.what();
  for (const std::string& word : root.remaining(true)) {
    if (!word.starts_with("-") && command != &root) continue;
    problem = fmt::format("there is no '{}'{}", word, suggestion(word, *command));
    break;
  }
  fmt::print(stderr, "{}: {} (see {} --help)\n", name, problem, name);
  return kWrongUsage;
}

}  // namespace

const Flag& Flag::required() const { return option_->required(), *this; }
const Flag& Flag::type_name(const std::string& name) const { return option_->type_name(name), *this; }
const Flag& Flag::group(const std::string& heading) const { return option_->group(heading), *this; }
const Flag& Flag::values(int count, char delimiter) const { return option_->delimiter(delimiter)->expected(count), *this; }
const Flag& Flag::single() const { return option_->expected(1), *this; }
const Flag& Flag::one_word_each() const { return option_->allow_extra_args(false), *this; }
const Flag& Flag::range(int least, int most) const { return option_->check(CLI::Range(least, most)), *this; }
const Flag& Flag::range(double least, double most) const { return option_->check(CLI::Range(least, most)), *this; }
const Flag& Flag::positive() const { return option_->check(CLI::PositiveNumber), *this; }
const Flag& Flag::not_negative() const { return option_->check(CLI::NonNegativeNumber), *this; }
const Flag& Flag::one_of(std::initializer_list<const char*> words) const { return option_->check(CLI::IsMember(words)), *this; }
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

void Command::when_named(std::function<void()> then) const { app_->callback(std::move(then)); }

CommandLine::CommandLine(const std::string& name, const std::string& doc, const std::string& version)
    : app_(std::make_unique<CLI::App>(doc, name)) {
  app_->set_version_flag("--version", version, "Print the version and exit");
  app_->set_help_flag("-h,--help", "Print this help and exit");
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& outcome) {
    return report(outcome, *app_);
  }
  return std::nullopt;
}

}  // namespace lippmann::app
