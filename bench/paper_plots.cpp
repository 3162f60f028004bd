#include "bench/paper_plots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "compare/gnuplot.hpp"
#include "core/folder.hpp"

namespace lippmann::bench {
namespace {

namespace fs = std::filesystem;

/// Key frames, and frames whose value is missing, leave gaps in gnuplot's curve.
template <class Fn>
std::string data(const std::string& name, const ReuseRun& run, const Fn& value) {
  std::string text = "$" + name + " << EOD\n";
  for (const ReuseFrame& frame : run.frames) {
    const double v = frame.key ? NAN : value(frame);
    text += std::isfinite(v) ? fmt::format("{} {}\n", frame.frame, v) : "\n";
  }
  return text + "EOD\n";
}

std::string psnr_commands(const std::string& scene, const std::vector<const ReuseRun*>& runs) {
  std::string text, curves;
  const ReuseRun* longest = runs.front();
  for (const ReuseRun* run : runs) {
    if (run->keyframes > longest->keyframes) longest = run;
    const std::string name = fmt::format("k{}", run->keyframes);
    text += data(name, *run, [](const ReuseFrame& f) { return f.likeness.psnr_db; });
    curves +=
        fmt::format("${} with linespoints pointtype 7 pointsize 0.6 title 'every {}. frame traced', ", name, run->keyframes);
  }
  text += data("blend", *longest, [](const ReuseFrame& f) { return f.blend_psnr; });
  curves += fmt::format("$blend with lines dashtype 2 title 'key frames blended, every {}. traced'", longest->keyframes);
  return text + fmt::format(
                    "set title {}\nset xlabel 'frame'\nset ylabel 'PSNR against the traced frame, dB'\nset grid\n"
                    "set key outside below\nplot {}\n",
                    gnuplot_quoted(scene + ", interpolated frames"), curves);
}

std::string saving_commands(const std::vector<ReuseRun>& runs) {
  std::string text = "$saving << EOD\n", scene;
  std::vector<int> intervals;
  for (const ReuseRun& run : runs) {
    if (run.method != "forward") continue;
    if (run.scene != scene) text += fmt::format("{}\"{}\"", scene.empty() ? "" : "\n", run.scene);
    scene = run.scene;
    text += fmt::format(" {}", 100.0 * run.saving());
    if (std::find(intervals.begin(), intervals.end(), run.keyframes) == intervals.end()) intervals.push_back(run.keyframes);
  }
  text +=
      "\nEOD\nset style data histograms\nset style fill solid 0.8\nset boxwidth 0.9\nset yrange [*:100]\nset grid y\n"
      "set ylabel 'CPU time saved over the whole animation, %'\nset xtics rotate by -20\nset key outside below\nplot ";
  for (std::size_t i = 0; i < intervals.size(); ++i)
    text += fmt::format("{}$saving using {}{} title 'every {}. frame traced'", i > 0 ? ", " : "", i + 2,
                        i == 0 ? ":xtic(1)" : "", intervals[i]);
  return text + '\n';
}

}  // namespace

void plot_reuse(const std::vector<ReuseRun>& runs, const fs::path& folder) {
  make_folder(folder);
  for (std::size_t begin = 0; begin < runs.size();) {
    std::vector<const ReuseRun*> of_scene;
    const std::string& scene = runs[begin].scene;
    for (; begin < runs.size() && runs[begin].scene == scene; ++begin)
      if (runs[begin].method == "forward") of_scene.push_back(&runs[begin]);
    std::string name = scene;
    std::replace(name.begin(), name.end(), ' ', '-');
    draw_with_gnuplot(folder / ("psnr_" + name + ".png"), psnr_commands(scene, of_scene));
  }
  draw_with_gnuplot(folder / "saving.png", saving_commands(runs));
}

}  // namespace lippmann::bench
