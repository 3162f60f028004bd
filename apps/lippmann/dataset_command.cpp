// `lippmann dataset SCENES... -o DIR`: renders light fields of random scenes, for training.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/grid_flag.hpp"
#include "apps/lippmann/print.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/progress.hpp"
#include "core/printable.hpp"
#include "lippmann/dataset/dataset.hpp"

namespace lippmann::app {
namespace {

struct DatasetOptions {
  std::vector<std::string> scenes;
  std::string folder, views = "9x9", unit;
  int count = 0, seed = 0, spp = 16, threads = 0;
  int size = 128;
  bool json = false, quiet = false;
};

DatasetParams dataset_params(const DatasetOptions& options) {
  DatasetParams params;
  params.scenes = options.scenes;
  params.folder = options.folder;
  params.count = options.count;
  params.seed = static_cast<std::uint32_t>(options.seed);
  params.grid = *read_grid(options.views, "--views");
  params.view_size = {options.size, options.size};
  params.spp = options.spp;
  params.unit = options.unit;
  return params;
}

void print_dataset_report(const DatasetReport& report, const DatasetOptions& options) {
  if (options.json)
    return print_json({{"folder", options.folder},
                       {"samples", report.wanted},
                       {"kept", report.kept},
                       {"made", report.made},
                       {"remade", report.remade},
                       {"seconds", report.seconds},
                       {"bytes", report.bytes},
                       {"complete", report.is_complete}});
  const std::string folder = printable_line(options.folder);
  const std::string remade = report.remade > 0 ? fmt::format(" ({} to replace damaged samples)", report.remade) : "";
  print_out("{} samples made in {:.1f} s{}, {} kept: {}\n", report.made, report.seconds, remade, report.kept, folder);
  if (report.is_complete) print_out("  complete  {}/manifest.json\n", folder);
}

int run(const DatasetOptions& options, Context& context) {
  context.threads = options.threads;
  std::optional<Progress> progress;
  DatasetObserver observer;
  observer.planned = [&](int to_make, int) {
    if (to_make > 0 && !options.quiet) progress.emplace(to_make, Progress::usual_style());
  };
  observer.made = [&](int index, double seconds) {
    if (progress) progress->step(fmt::format("sample {}: {:.1f} s", index, seconds));
  };
  context.frame_progress = [&](double share) {
    if (progress) progress->within(share);
  };
  const DatasetReport report = make_dataset(dataset_params(options), context, observer);
  context.frame_progress = nullptr;
  progress.reset();
  print_dataset_report(report, options);
  return context.cancelled ? 1 : 0;
}

}  // namespace

void add_dataset_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<DatasetOptions>();
  const Command command = root.add_command(
      "dataset", "Make light fields of random scenes with depth, disparity, normals, motion and ids, for training");
  command.add_option("SCENES", options->scenes, "Scenes whose meshes become objects, beside spheres and boxes").required();
  command.add_option("-o,--output", options->folder, "The folder of the samples; complete samples in it are kept")
      .type_name("DIR")
      .required();
  command.add_option("--count", options->count, "Number of samples").type_name("N").required();
  command.add_option("--seed", options->seed, "Seed of the random scenes; default: 0").range(0, 1 << 30);
  command.add_option("--views", options->views, "Cameras across and up; default: 9x9").type_name("CxR");
  command.add_option("--size", options->size, "Width and height of a view in pixels; default: 128").range(8, 4096);
  command.add_option("--spp", options->spp, "Samples per pixel; default: 16").range(1, 4096);
  command.add_option("--unit", options->unit, "Make only the I-th of N parts; other runs make the rest").type_name("I/N");
  command.add_flag("--json", options->json, "Print figures as JSON");
  command.add_flag("-q,--quiet", options->quiet, "No progress");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
