// Each benchmark checks its results, measures, and returns rows of figures. The two times of a ratio are measured
// alternately within one run, because times depend on the machine's load.
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
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  nlohmann::ordered_json details;
  std::string text;
  int passed_checks = 0;
  std::vector<std::string> failed_checks{};  ///< one line for each check that failed; the rows of other checks are still valid
};

/// The options of all benchmarks together. A benchmark reads those that its `add_options` declares.
struct Request {
  std::vector<std::string> scenes;
  int frames = 0;
  /// Number of columns and rows of views, as CxR. If empty: 3x1 if view_pixels is set, otherwise the default of each scene.
  std::string views;
  int view_pixels = 0;
  bool large = false;  ///< also measure 3840 x 2160 pixels
  bool quick = false;  ///< measure only a few small frames, to check that the benchmark works
  int reference_spp = 0;
  std::string references;  ///< folder in which reference frames are kept; if empty, lippmann/references in the user's cache
  std::string pictures;
  bool list = false;
  std::string plot;
  std::string csv;
  std::string tachyon_scenes = "/usr/share/doc/tachyon/examples/scenes";
  std::function<void(std::string_view)> say;
};

struct Benchmark {
  std::string_view name;
  std::string_view description;
  Report (*run)(const Request& request, const Context& context);
  void (*add_options)(CLI::App& command, Request& request);
};

Error interrupted();

/// Reports the next step of a benchmark to `request.say`. Throws `interrupted()` if `context` is cancelled.
void begin_step(const Request& request, const Context& context, std::string_view what);

const std::vector<Benchmark>& benchmarks();

}  // namespace lippmann::bench
