// Declares commands, their flags and the text of --help. Only command_line.cpp includes CLI11, because its headers take seconds
// to compile.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/error.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lippmann::app {

constexpr int kWrongUsage = 2;  ///< exit code

/// Replaces the names of parameters in backquotes, such as `min-psnr`, by their flags, such as --min-psnr.
std::string with_flags(std::string_view text);

/// A flag or positional argument of a command. A value outside the declared range or list is a usage error.
class Flag {
 public:
  explicit Flag(CLI::Option& option) : option_(&option) {}

  const Flag& required() const;
  const Flag& type_name(const std::string& name) const;  ///< sets the name of the flag's value in --help
  const Flag& group(const std::string& heading) const;   ///< sets the heading below which --help lists the flag
  const Flag& values(int count, char delimiter) const;   ///< the flag takes one word that lists `count` values
  const Flag& single() const;                            ///< the flag takes one word, although its variable is a list
  /// Each occurrence of the flag adds one value to its list.
  const Flag& one_word_each() const;
  const Flag& range(int least, int most) const;
  const Flag& range(double least, double most) const;
  const Flag& positive() const;
  const Flag& not_negative() const;
  const Flag& one_of(std::initializer_list<const char*> words) const;
  bool given() const;                ///< whether the command line has the flag; call after parsing
  const Flag& show_default() const;  ///< makes --help print the variable's present value

 private:
  CLI::Option* option_;
};

/// A command, or a group of its flags below a heading of --help. The variables of its flags must outlive CommandLine::parse,
/// which writes them. Names are given as in "-o,--output". A name without dashes declares a positional argument.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command add_command(const std::string& name, const std::string& doc) const;
  Command add_group(const std::string& heading, const std::string& doc = {}) const;
  /// Value is std::string, int, double, an optional int or double, or a vector of std::string or double.
  template <typename Value>
  Flag add_option(const std::string& names, Value& value, const std::string& doc) const;
  Flag add_flag(const std::string& names, bool& value, const std::string& doc) const;
  Flag add_flag(const std::string& names, std::function<void()> when_given, const std::string& doc) const;
  void footer(const std::string& text) const;  ///< sets the last lines of --help
  void hide() const;                           ///< leaves the command out of --help
  /// Adds --help-all and limits --help to the examples and these flags.
  void short_help(std::vector<std::string> flags, std::string examples) const;
  /// Sets a function to call after parsing if the command line names this command.
  void when_named(std::function<void()> then) const;

 private:
  CLI::App* app_;
};

class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& doc, const std::string& version);
  ~CommandLine();

  Command root() { return Command(*app_); }
  /// Returns nullopt if a command is ready to run. Otherwise prints help, the version or an error, and returns the exit code.
  std::optional<int> parse(int argc, char** argv);

  /// Returns the possible values of a flag or argument whose declaration does not list them. name: without dashes.
  using ValuesOf = std::function<std::vector<std::string>(const std::string& name)>;
  /// Returns the completions of the last word. words: the words after the tool's name. ":files" in the result requests file
  /// names from the shell.
  std::vector<std::string> completions(const std::vector<std::string>& words, const ValuesOf& values_of) const;

  /// Returns the manual page of all commands and flags, for man(1).
  std::string manual() const;
  /// Returns the reference of all commands and flags as Markdown, for docs/reference/command-line.md.
  std::string reference() const;

  /// Returns the message of an Error with flags in place of parameter names.
  std::string message_of(const Error& error) const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace lippmann::app
