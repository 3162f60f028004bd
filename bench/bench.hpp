// The benchmarks of lippmann-bench. Each benchmark checks its results, measures, and returns rows of figures.
//
// Absolute times depend on the machine and its load. Therefore both sides of a ratio are measured alternately within one run.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/core/error.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace lippmann::bench {

struct Report {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();  ///< one object per line of the table, all with the same keys
  nlohmann::ordered_json details;                                 ///< further figures for --json; null if there are none
  std::string text;                          ///< printed instead of the table of rows; if empty, the table is printed
  int passed_checks = 0;                     ///< number of checks that the results passed
  std::vector<std::string> failed_checks{};  ///< one line for each check that failed; the rows of other checks are still valid
};

/// The options of all benchmarks together. A benchmark reads those that its `add_options` declares.
struct Request {
  std::vector<std::string> scenes;  ///< names or files; if empty, the benchmark's default
  int frames = 0;                   ///< frames per animation; 0 means the benchmark's default
  /// columns and rows of views as CxR; if empty, the default of each row of the table, or 3x1 if view_pixels is set
  std::string views;
  int view_pixels = 0;     ///< width and height of a view in pixels; 0 means the benchmark's default
  bool large = false;      ///< also measure 3840 x 2160 pixels
  bool quick = false;      ///< measure only a few small frames, to check that the benchmark works
  int reference_spp = 0;   ///< samples per pixel of the reference frames; 0 means the benchmark's default
  std::string references;  ///< folder in which reference frames are kept; if empty, lippmann/references in the user's cache
  std::string pictures;    ///< folder for the compared pictures; if empty, none are written
  bool list = false;       ///< return the names of the rows as text, without measuring
  std::string plot;        ///< folder for plots; if empty, none are written
  std::string csv;         ///< file for the summary; if empty, none is written
  /// folder with teapot.dat, teapot.cam and other files
  std::string tachyon_scenes = "/usr/share/doc/tachyon/examples/scenes";
  std::function<void(std::string_view)> say;  ///< is called with each line of progress; may be empty
};

struct Benchmark {
  std::string_view name;
  std::string_view description;                                   ///< one line for --help
  Report (*run)(const Request& request, const Context& context);  ///< throws Error if a check fails
  void (*add_options)(CLI::App& command, Request& request);       ///< declares the options that `run` reads
};

/// Returns the error that ends a cancelled benchmark.
Error interrupted();

/// Reports the next step of a benchmark to `request.say`. Throws `interrupted()` if `context` is cancelled.
void begin_step(const Request& request, const Context& context, std::string_view what);

/// Returns all benchmarks in the order of --help.
const std::vector<Benchmark>& benchmarks();

}  // namespace lippmann::bench
