#include "compare/plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "compare/gnuplot.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// For up to this number of frames, tick marks are set one by one, because gnuplot would put some between frame numbers.
constexpr std::size_t kFewFrames = 20;

std::optional<long> trailing_number(const std::string& name) {
  constexpr std::size_t kMaxDigits = 9;
  std::size_t begin = name.size();
  while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9') --begin;
  if (begin == name.size() || name.size() - begin > kMaxDigits) return std::nullopt;
  return std::stol(name.substr(begin));
}

std::string make_commands(const Comparison& comparison) {
  std::string script = "$psnr << EOD\n";
  for (std::size_t i = 0; i < comparison.frames.size(); ++i) {
    const double psnr = comparison.frames[i].metrics.psnr_db;
    const long frame = trailing_number(comparison.frames[i].name).value_or(static_cast<long>(i));
    script += std::isfinite(psnr) ? fmt::format("{} {}\n", frame, psnr) : "\n";
  }
  script +=
      "EOD\nset xlabel 'frame'\nset ylabel 'PSNR, dB'\nset grid\nset offsets graph 0.02, graph 0.02, graph 0.1, graph 0.1\n";
  if (comparison.frames.size() <= kFewFrames) script += "set xtics 1\n";
  const std::string title = comparison.mean_psnr_db ? fmt::format("mean {:.2f} dB", *comparison.mean_psnr_db) : "identical";
  script += fmt::format("plot $psnr using 1:2 with linespoints pointtype 7 pointsize 0.5 title {}\n", gnuplot_quoted(title));
  return script;
}

}  // namespace

void plot_psnr(const Comparison& comparison, const fs::path& path) {
  bool any = false;
  for (const FrameComparison& frame : comparison.frames) any = any || std::isfinite(frame.metrics.psnr_db);
  if (!any) throw Error(path.string(), "there is nothing to plot: every frame is identical");
  draw_with_gnuplot(path, make_commands(comparison));
}

}  // namespace lippmann
