// The benchmarks that `lippmann bench` runs: each checks its results first, then measures, and returns rows of figures.
//
// Every ratio in a row comes from one run, its two sides measured in turn, because absolute times vary with the machine.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"

namespace lippmann::bench {

struct Report {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();  ///< one object per line of the table, all with the same keys
  nlohmann::ordered_json details;                                 ///< what rows are made of, an object; null: nothing more
  std::string text;       ///< for people, instead of the table of rows; empty: that table
  int passed_checks = 0;  ///< how many checks results have passed; a failed one throws Error, or is among failed_checks
  std::vector<std::string> failed_checks{};  ///< one line each; the other rows of the table are worth having all the same
};

/// What a person can choose.
struct Request {
  int frames = 0;                             ///< for each animation; 0: the benchmark's own choice
  std::string views;                          ///< CxR views in place of a row's own optics; empty: these
  int view_pixels = 0;                        ///< sides of a view, where there are views; 0: the row's own, else 120
  bool large = false;                         ///< pictures of 3840 x 2160 pixels too
  bool quick = false;                         ///< small and few, to see that it works
  int reference_spp = 0;                      ///< samples of references; 0: the benchmark's own choice
  std::string references;                     ///< folder where they are kept; empty: the user's cache
  std::function<void(std::string_view)> say;  ///< a line of progress; may be empty
  std::string pictures;                       ///< folder for pictures of what was compared; empty: none
  bool list = false;                          ///< say what scenes there are, and measure nothing
  std::string plot;                           ///< folder for plots; empty: none
  std::string csv;                            ///< file for the rows that the benchmark sums up in; empty: none
  std::vector<std::string> scenes;            ///< by name; empty: all that the benchmark has
  std::string tachyon_scenes = "/usr/share/doc/tachyon/examples/scenes";  ///< the folder of Tachyon's teapot.dat and others
};

struct Benchmark {
  std::string_view name;
  std::string_view description;  ///< one line for --help
  Report (*run)(const Request& request, const Context& context);
  std::vector<std::string_view> options = {};  ///< the flags that it takes; others are wrong usage
};

/// To be called before each step of a benchmark: says on what it works, and throws Error once the benchmark has been stopped.
void begin_step(const Request& request, const Context& context, std::string_view what);

/// In the order that --help lists them.
const std::vector<Benchmark>& benchmarks();

}  // namespace lippmann::bench
