// The benchmarks of lippmann-bench. Each one checks its results first, then measures, and returns rows of figures.
//
// Absolute times vary with the machine and its load, so both sides of every ratio are measured in turn within one run.
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
  nlohmann::ordered_json details;                                 ///< the figures behind the rows, for --json; null: none
  std::string text;                          ///< printed instead of the table of rows; empty: the table is printed
  int passed_checks = 0;                     ///< number of checks that the results passed
  std::vector<std::string> failed_checks{};  ///< one line per check that failed but leaves the other rows valid
};

/// The options of all benchmarks together. A benchmark reads those that its `add_options` declares.
struct Request {
  std::vector<std::string> scenes;  ///< names or files; empty: the benchmark's default
  int frames = 0;                   ///< frames per animation; 0: the benchmark's default
  std::string views;                ///< CxR, replaces the views of each row; empty: the row's own, or 3x1 if view_pixels is set
  int view_pixels = 0;              ///< width and height of a view; 0: the benchmark's default
  bool large = false;               ///< also measure 3840 x 2160 pixels
  bool quick = false;               ///< few small frames, to check that the benchmark works
  int reference_spp = 0;            ///< samples per pixel of the references; 0: the benchmark's default
  std::string references;           ///< folder of kept references; empty: lippmann/references in the user's cache
  std::string pictures;             ///< folder for the compared pictures; empty: none are written
  bool list = false;                ///< return the names of the rows as text and measure nothing
  std::string plot;                 ///< folder for plots; empty: none
  std::string csv;                  ///< file for the summary; empty: none
  std::string tachyon_scenes = "/usr/share/doc/tachyon/examples/scenes";  ///< folder of teapot.dat, teapot.cam and so on
  std::function<void(std::string_view)> say;                              ///< receives one line of progress; may be empty
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
