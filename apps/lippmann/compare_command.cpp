// `lippmann compare REFERENCE TEST`: prints the differences between pictures, folders of frames or videos.
#include <fmt/core.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/grid_flag.hpp"
#include "compare/compare.hpp"
#include "compare/comparison_text.hpp"
#include "compare/plot.hpp"
#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/frame_ranges.hpp"
#include "formats/rendered.hpp"
#include "job/params.hpp"

namespace lippmann::app {
namespace {

struct CompareOptions {
  std::string reference, test, csv, plot, frames, metrics, from, views, quilt;
  int threads = 0;
  bool json = false, per_view = false;
};

void write_text(const std::string& path, const std::string& text) {
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

CompareParams compare_params(const CompareOptions& options) {
  CompareParams params;
  if (!options.frames.empty()) params.frames = frames_of(read_frames(options.frames, "--frames"));
  if (!options.metrics.empty()) params.choice = read_metrics(options.metrics);
  params.per_view = options.per_view;
  params.hints = {options.from, read_grid(options.views, "--views"), read_grid(options.quilt, "--quilt")};
  return params;
}

int run(const CompareOptions& options, Context& context) {
  const NewFolder csv_folder(std::filesystem::path(options.csv).parent_path());
  const NewFolder plot_folder(std::filesystem::path(options.plot).parent_path());
  for (const std::string& path : {options.csv, options.plot})
    if (!path.empty()) AtomicFile{path};  // throws now if the file cannot be written
  context.threads = options.threads;
  const CompareParams params = compare_params(options);
  for (const std::string& in : {options.reference, options.test}) warn_about_unchecked_files(in, context);
  const Comparison comparison = compare(options.reference, options.test, context, params);
  if (context.cancelled) return 1;
  if (!options.csv.empty()) write_text(options.csv, comparison_csv(comparison));
  if (!options.plot.empty()) plot_psnr(comparison, options.plot);
  fmt::print("{}", options.json ? comparison_json(comparison) : comparison_table(comparison, params.choice));
  return 0;
}

}  // namespace

void add_compare_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<CompareOptions>();
  const Command command = root.add_command(
      "compare", "Print MSE, RMSE, PSNR, SSIM and more of pictures, light fields, folders of frames or videos");
  command.add_option("REFERENCE", options->reference, "The reference: a picture, a folder or a video").required();
  command.add_option("TEST", options->test, "The picture, folder or video to compare with it").required();
  command
      .add_option("--frames", options->frames,
                  "Compare only frames A to B, both included; lists and steps: 0,2,4 or 0-10:2; other frames may be missing")
      .type_name("A-B");
  command
      .add_option(
          "--metrics", options->metrics,
          "Also psnr-y, psnr-yuv, ms-ssim, flip, angular (between neighbouring views) or flicker (along the layer motion "
          "of REFERENCE), separated by commas; or all that the inputs allow")
      .type_name("LIST");
  command.add_flag("--per-view", options->per_view, "Compare each view of a light field separately");
  command.add_option("--from", options->from, "Format of light fields without a report.json, as in convert")
      .type_name("FORMAT");
  command.add_option("--views", options->views, "Number of views across and up").type_name("CxR");
  command.add_option("--quilt", options->quilt, "Number of tiles of a quilt").type_name("CxR");
  command.add_flag("--json", options->json, "Print the result as JSON");
  command.add_option("--csv", options->csv, "Also write one line per frame to this file");
  command.add_option("--plot", options->plot, "Also draw the PSNR of every frame into this PNG (needs gnuplot)");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
