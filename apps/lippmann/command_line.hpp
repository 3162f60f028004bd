// The command line as commands declare it: what they take, into which variable, and what --help says of it. CLI11 does the
// work and stays in command_line.cpp: whatever includes it takes seconds longer to compile.
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

/// The library names its parameters in backquotes, `min-psnr`: the text with flags, --min-psnr, in place of these.
std::string with_flags(std::string_view text);

/// A flag, or an argument without a name, that a command has declared.
class Flag {
 public:
  explicit Flag(CLI::Option& option) : option_(&option) {}

  const Flag& required() const;
  const Flag& type_name(const std::string& name) const;                ///< what --help calls its value
  const Flag& group(const std::string& heading) const;                 ///< below which --help lists it
  const Flag& values(int count, char delimiter) const;                 ///< a list of so many, in one word
  const Flag& single() const;                                          ///< takes one word, though its variable is a list
  const Flag& one_word_each() const;                                   ///< a list grows by saying the flag again only
  const Flag& range(int least, int most) const;                        ///< both included; else wrong usage
  const Flag& range(double least, double most) const;                  ///< likewise
  const Flag& positive() const;                                        ///< else wrong usage
  const Flag& not_negative() const;                                    ///< likewise
  const Flag& one_of(std::initializer_list<const char*> words) const;  ///< else wrong usage
  bool given() const;                                                  ///< after parsing: whether the command line has it
  const Flag& show_default() const;                                    ///< --help names the value that its variable has now

 private:
  CLI::Option* option_;
};

/// A command, or a group of its flags below a heading of --help. Variables are filled by CommandLine::parse: they must live so
/// long. Names are as in "-o,--output"; a name without dashes is that of an argument.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command add_command(const std::string& name, const std::string& doc) const;
  Command add_group(const std::string& heading, const std::string& doc = {}) const;
  /// Value: std::string, int, double, std::optional of these numbers, std::vector of strings or of double.
  template <typename Value>
  Flag add_option(const std::string& names, Value& value, const std::string& doc) const;
  Flag add_flag(const std::string& names, bool& value, const std::string& doc) const;
  Flag add_flag(const std::string& names, std::function<void()> when_given, const std::string& doc) const;
  void footer(const std::string& text) const;  ///< ends --help
  void hide() const;                           ///< for programs to call: --help does not list it
  /// Adds --help-all; --help then lists these flags alone, below the examples.
  void short_help(std::vector<std::string> flags, std::string examples) const;
  void when_named(std::function<void()> then) const;  ///< called once all is parsed

 private:
  CLI::App* app_;
};

/// The tool: its commands, of which the command line names one.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& doc, const std::string& version);
  ~CommandLine();

  Command root() { return Command(*app_); }
  /// None: a command was named and is ready to run. Else all is printed, on stdout --help or --version, on stderr one line
  /// about wrong usage, and this is the exit code.
  std::optional<int> parse(int argc, char** argv);

  /// Values of a flag, named without dashes, or of an argument, that its declaration does not list.
  using ValuesOf = std::function<std::vector<std::string>(const std::string& name)>;
  /// What the last of these words, which follow the tool's name, may become; ":files" among them: a file's name, too.
  std::vector<std::string> completions(const std::vector<std::string>& words, const ValuesOf& values_of) const;

  /// The manual page, for man(1): all commands with all their flags.
  std::string manual() const;

  /// What an Error says, in the words of the command line.
  std::string message_of(const Error& error) const;

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace lippmann::app
