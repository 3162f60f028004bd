#include "report/render_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "report/figure_text.hpp"
#include "report/frame_charts.hpp"
#include "report/frame_origins.hpp"

namespace lippmann {
namespace {

/// Returns the number of frames of each kind, for example "1 key, 7 in-between".
std::string kinds_text(const RenderFigures& render) {
  std::map<std::string, int> kinds;
  for (const FrameReport& frame : render.frames) ++kinds[frame.kind];
  std::string text;
  for (const auto& [kind, count] : kinds) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
  return text;
}

double mean_share(const RenderFigures& render, Origin origin) {
  double sum = 0.0;
  for (const FrameReport& frame : render.frames)
    if (const auto shares = origins_of(frame, render)) sum += (*shares)[static_cast<std::size_t>(origin)];
  return sum / static_cast<double>(render.frames.size());
}

SummaryFigure traced_figure(const RenderFigures& render) {
  const bool is_known = std::all_of(render.frames.begin(), render.frames.end(),
                                    [&](const FrameReport& frame) { return origins_of(frame, render).has_value(); });
  if (!is_known || render.frames.empty()) return {"pixels traced", kNotKnown, ""};
  std::string others;
  for (const Origin origin : {Origin::kCopied, Origin::kInterpolated, Origin::kFilled})
    if (const double share = mean_share(render, origin); share > 0.0)
      others += fmt::format("{}{} {}", others.empty() ? "" : ", ", percent_text(share),
                            kOriginNames[static_cast<std::size_t>(origin)]);
  return {"pixels traced", percent_text(mean_share(render, Origin::kTraced)),
          others.empty() ? "every pixel of every frame" : others};
}

bool is_interpolated(const FrameReport& frame, const RenderFigures& render) {
  return frame.kind == "in-between" && render.reuse != "copy" && render.reuse != "exact";
}

std::string unestimated(const RenderFigures& render) {
  const auto guessed = [&](const FrameReport& frame) { return is_interpolated(frame, render); };
  if (std::any_of(render.frames.begin(), render.frames.end(), guessed))
    return "interpolated without min-psnr: the error was not measured";
  return render.frames.empty() ? "" : "all pixels are traced or exact copies";
}

SummaryFigure psnr_figure(const RenderFigures& render) {
  const FrameReport* worst = worst_frame(render);
  if (!worst) return {"lowest PSNR", kNotKnown, unestimated(render)};
  const char* how = worst->psnr_at_least_db ? "at least, at 95 % confidence" : "estimated";
  return {"lowest PSNR", decibel_text(sure_psnr_db(*worst)), fmt::format("{}; frame {}", how, worst->frame)};
}

bool is_traced_throughout(const RenderFigures& render) {
  return !render.frames.empty() && std::all_of(render.frames.begin(), render.frames.end(), is_traced_whole);
}

SummaryFigure saving_figure(const RenderFigures& render) {
  const std::optional<double> saved = total_saving(render);
  const char* why = saved                          ? "compared with frames traced in full; source frames are counted"
                    : is_traced_throughout(render) ? "every frame was traced in full"
                                                   : "no frame was traced in full for comparison";
  return {"CPU time saved", percent_text(saved), why};
}

RayCounts all_rays(const RenderFigures& render) {
  RayCounts rays;
  for (const FrameReport& frame : render.frames) add(frame.rays, rays);
  return rays;
}

SummaryFigure time_figure(const RenderFigures& render) {
  const std::optional<double> mean = cpu_seconds_a_frame(render);
  const std::string sources =
      render.source_frames > 0.0 ? fmt::format(", with {} source frames", count_text(render.source_frames)) : "";
  return {"CPU time per frame", mean ? seconds_text(*mean) : kNotKnown,
          fmt::format("{} in all{}", seconds_text(render.cpu_seconds), sources)};
}

}  // namespace

std::optional<double> cpu_seconds_a_frame(const RenderFigures& render) {
  if (render.frames.empty()) return std::nullopt;
  return render.cpu_seconds / static_cast<double>(render.frames.size());
}

std::optional<double> total_saving(const RenderFigures& render) {
  const std::optional<double> mean = cpu_seconds_a_frame(render);
  return mean && !is_traced_throughout(render) ? saving(*mean, traced_cpu_seconds(render)) : std::nullopt;
}

const FrameReport* worst_frame(const RenderFigures& render) {
  const FrameReport* worst = nullptr;
  for (const FrameReport& frame : render.frames)
    if (sure_psnr_db(frame) && (!worst || *sure_psnr_db(frame) < *sure_psnr_db(*worst))) worst = &frame;
  return worst;
}

std::vector<SummaryFigure> render_summary(const RenderFigures& render) {
  const double rays = static_cast<double>(all_rays(render).total());
  const double frames = std::max(1.0, static_cast<double>(render.frames.size()));
  const std::string per_pixel =
      render.pixels && rays > 0.0 ? fmt::format("{:.3g} per pixel", rays / frames / *render.pixels) : std::string();
  return {{"frames", count_text(static_cast<double>(render.frames.size())), kinds_text(render)},
          time_figure(render),
          saving_figure(render),
          traced_figure(render),
          psnr_figure(render),
          {"rays per frame", count_text(rays / frames), per_pixel},
          {"peak memory", memory_text(render.peak_memory_bytes), "of the largest run"}};
}

}  // namespace lippmann
