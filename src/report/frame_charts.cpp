#include "report/frame_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "core/number_text.hpp"
#include "report/frame_origins.hpp"

namespace lippmann {
namespace {

using Figure = std::function<std::optional<double>(const FrameReport&)>;

ChartSeries series_of(const RenderFigures& render, std::string name, int color, const Figure& figure) {
  ChartSeries series{std::move(name), color, {}};
  for (const FrameReport& frame : render.frames) series.values.push_back(figure(frame));
  return series;
}

std::vector<int> numbers_of(const RenderFigures& render) {
  std::vector<int> numbers;
  for (const FrameReport& frame : render.frames) numbers.push_back(frame.frame);
  return numbers;
}

bool has_any(const ChartSeries& series) {
  return std::any_of(series.values.begin(), series.values.end(), [](const auto& value) { return value && *value != 0.0; });
}

void keep_used(std::vector<ChartSeries>& series) {
  std::erase_if(series, [](const ChartSeries& one) { return !has_any(one); });
}

bool was_interpolated(const RenderFigures& render) { return render.reuse == "interpolate" || render.reuse == "forward"; }

void add_psnr_levels(const RenderFigures& render, Chart& chart) {
  if (was_interpolated(render)) chart.levels.push_back({fmt::format("the paper's {:.1f} dB", kPaperPsnrDb), kPaperPsnrDb});
  if (const auto floor = wanted_psnr_db(render)) chart.levels.push_back({fmt::format("requested: {:.4g} dB", *floor), *floor});
}

std::optional<double> percent(std::optional<double> share) { return share ? std::optional(100.0 * *share) : std::nullopt; }

struct Comparison {
  std::set<int> numbers;
  std::vector<std::map<int, const FrameReport*>> by_number;

  explicit Comparison(const std::vector<RenderFigures>& renders) {
    for (const RenderFigures& render : renders) {
      by_number.emplace_back();
      for (const FrameReport& frame : render.frames) numbers.insert(frame.frame), by_number.back()[frame.frame] = &frame;
    }
  }

  const FrameReport* find(std::size_t render, int number) const {
    const auto found = by_number[render].find(number);
    return found == by_number[render].end() ? nullptr : found->second;
  }

  using FigureOf = std::function<std::optional<double>(std::size_t render, int number, const FrameReport& frame)>;
  void fill(const std::vector<std::string>& names, const FigureOf& figure, Chart& chart) const {
    chart.frames.assign(numbers.begin(), numbers.end());
    for (std::size_t i = 0; i < by_number.size(); ++i) {
      ChartSeries series{names[i], static_cast<int>(i % 8), {}};
      for (const int number : numbers) {
        const FrameReport* frame = find(i, number);
        series.values.push_back(frame ? figure(i, number, *frame) : std::nullopt);
      }
      chart.series.push_back(std::move(series));
    }
  }
};

}  // namespace

std::optional<double> wanted_psnr_db(const RenderFigures& render) {
  const auto floor = render.settings.find("min-psnr");
  if (floor == render.settings.end()) return std::nullopt;
  if (floor->is_number()) return floor->get<double>();
  return floor->is_string() ? parse_number<double>(floor->get<std::string>()) : std::nullopt;
}

std::optional<double> sure_psnr_db(const FrameReport& frame) {
  return frame.psnr_at_least_db ? frame.psnr_at_least_db : frame.estimated_psnr_db;
}

Chart psnr_chart(const RenderFigures& render) {
  Chart chart{"PSNR, estimated from held-out pixels", "dB"};
  chart.starts_at_zero = false, chart.frames = numbers_of(render);
  chart.series.push_back(series_of(render, "estimate", 0, [](const auto& frame) { return frame.estimated_psnr_db; }));
  chart.series.push_back(
      series_of(render, "at least (95 % confidence)", 1, [](const auto& frame) { return frame.psnr_at_least_db; }));
  chart.series.push_back(
      series_of(render, "at most (95 % confidence)", 4, [](const auto& frame) { return frame.psnr_at_most_db; }));
  keep_used(chart.series);
  add_psnr_levels(render, chart);
  return chart;
}

Chart origin_chart(const RenderFigures& render) {
  Chart chart{"Where pixels come from", "% of a frame"};
  chart.is_stacked = true, chart.top = 100.0, chart.frames = numbers_of(render);
  for (std::size_t i = 0; i < kOriginNames.size(); ++i)
    chart.series.push_back(series_of(render, std::string(kOriginNames[i]), static_cast<int>(i), [&](const FrameReport& frame) {
      const auto shares = origins_of(frame, render);
      return shares ? std::optional(100.0 * (*shares)[i]) : std::nullopt;
    }));
  keep_used(chart.series);
  return chart;
}

Chart time_chart(const RenderFigures& render) {
  Chart chart{"CPU time per frame", "s"};
  chart.is_stacked = true, chart.frames = numbers_of(render);
  const auto seconds_where = [](bool whole) {
    return [whole](const FrameReport& frame) {
      return is_traced_whole(frame) == whole ? std::optional(frame.cpu_seconds) : std::nullopt;
    };
  };
  chart.series.push_back(series_of(render, "traced whole", 0, seconds_where(true)));
  chart.series.push_back(series_of(render, "with reuse", 1, seconds_where(false)));
  keep_used(chart.series);
  return chart;
}

Chart saving_chart(const RenderFigures& render) {
  Chart chart{"CPU time saved", "% of a frame traced whole"};
  chart.frames = numbers_of(render);
  const std::optional<double> traced = traced_cpu_seconds(render);
  chart.series.push_back(series_of(render, "saved", 1, [&](const FrameReport& frame) {
    return is_traced_whole(frame) ? std::nullopt : percent(saving(frame.cpu_seconds, traced));
  }));
  return chart;
}

Chart ray_chart(const RenderFigures& render) {
  const double pixels = render.pixels.value_or(1e6);
  Chart chart{render.pixels ? "Rays per pixel" : "Rays per frame", render.pixels ? "rays" : "million rays"};
  chart.is_stacked = true, chart.frames = numbers_of(render);
  const auto rays_of = [&](std::uint64_t RayCounts::*kind) {
    return [pixels, kind](const FrameReport& frame) { return std::optional(static_cast<double>(frame.rays.*kind) / pixels); };
  };
  chart.series.push_back(series_of(render, "primary", 0, rays_of(&RayCounts::primary)));
  chart.series.push_back(series_of(render, "shadow", 2, rays_of(&RayCounts::shadow)));
  chart.series.push_back(series_of(render, "mirrored and refracted", 3, rays_of(&RayCounts::reflection)));
  chart.series.push_back(series_of(render, "indirect", 4, rays_of(&RayCounts::indirect)));
  keep_used(chart.series);
  return chart;
}

Chart psnr_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names) {
  Chart chart{"Lower bound of PSNR, estimated from held-out pixels", "dB"};
  chart.starts_at_zero = false;
  Comparison(renders).fill(
      names, [](std::size_t, int, const FrameReport& frame) { return sure_psnr_db(frame); }, chart);
  if (std::any_of(renders.begin(), renders.end(), was_interpolated))
    chart.levels.push_back({fmt::format("the paper's {:.1f} dB", kPaperPsnrDb), kPaperPsnrDb});
  keep_used(chart.series);
  return chart;
}

Chart time_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names) {
  Chart chart{"CPU time per frame", "s"};
  Comparison(renders).fill(
      names, [](std::size_t, int, const FrameReport& frame) { return std::optional(frame.cpu_seconds); }, chart);
  return chart;
}

Chart saving_comparison(const std::vector<RenderFigures>& renders, const std::vector<std::string>& names) {
  Chart chart{"CPU time saved", fmt::format("% of the same frame of {}", names.front())};
  const Comparison comparison(renders);
  comparison.fill(
      names,
      [&](std::size_t render, int number, const FrameReport& frame) -> std::optional<double> {
        const FrameReport* first = comparison.find(0, number);
        return render > 0 && first ? percent(saving(frame.cpu_seconds, first->cpu_seconds)) : std::nullopt;
      },
      chart);
  std::erase_if(chart.series, [](const ChartSeries& one) {
    return std::none_of(one.values.begin(), one.values.end(), [](const auto& value) { return value.has_value(); });
  });
  return chart;
}

}  // namespace lippmann
