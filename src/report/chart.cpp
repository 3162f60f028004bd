#include "report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/html.hpp"

namespace lippmann {
namespace {

/// The SVG's own units; both sides are stretched.
constexpr double kWidth = 1000.0, kHeight = 400.0;
/// Bars have gaps where there are so few of them.
constexpr std::size_t kMostBarsWithGaps = 120;
/// So many places tell their figures when they are pointed at: more would be narrower than a pixel.
constexpr std::size_t kMostTips = 600;

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  bool is_empty() const { return low > high; }
};

bool is_known(const std::optional<double>& value) { return value && std::isfinite(*value); }

std::optional<double> value_at(const ChartSeries& series, std::size_t slot) {
  if (slot >= series.values.size() || !is_known(series.values[slot])) return std::nullopt;
  return series.values[slot];
}

double stacked_at(const Chart& chart, std::size_t slot) {
  double sum = 0.0;
  for (const ChartSeries& series : chart.series) sum += std::max(value_at(series, slot).value_or(0.0), 0.0);
  return sum;
}

bool has_values(const Chart& chart) {
  for (const ChartSeries& series : chart.series)
    if (std::any_of(series.values.begin(), series.values.end(), is_known)) return true;
  return false;
}

Span span_of(const Chart& chart) {
  Span span;
  for (std::size_t slot = 0; slot < chart.slots.size(); ++slot) {
    if (chart.is_stacked) span.add(stacked_at(chart, slot));
    for (const ChartSeries& series : chart.series)
      if (const auto value = value_at(series, slot); value && !chart.is_stacked) span.add(*value);
  }
  for (const ChartLevel& level : chart.levels) span.add(level.value);
  if (chart.is_stacked || chart.starts_at_zero) span.add(0.0);
  return span;
}

/// 1, 2 or 5 times a power of ten, about a quarter of the length.
double step_for(double length) {
  const double rough = length / 4.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough * 0.999) return factor * power;
  return 10.0 * power;
}

/// As a part of the axis from below, 0 to 1.
double height_of(const ChartAxis& axis, double value) {
  return std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
}

double y_of(const ChartAxis& axis, double value) { return kHeight * (1.0 - height_of(axis, value)); }

double x_of(const Chart& chart, double slot) { return kWidth * slot / static_cast<double>(chart.slots.size()); }

/// Lines from middle to middle; a value alone is a dash across half its place.
std::string line_path(const Chart& chart, const ChartSeries& series, const ChartAxis& axis) {
  std::string path;
  bool is_open = false;
  for (std::size_t slot = 0; slot < chart.slots.size(); ++slot) {
    const std::optional<double> value = value_at(series, slot);
    const bool goes_on = value_at(series, slot + 1).has_value();
    const auto at = static_cast<double>(slot);
    if (value && (is_open || goes_on))
      path += fmt::format("{}{:.1f} {:.1f}", is_open ? 'L' : 'M', x_of(chart, at + 0.5), y_of(axis, *value));
    else if (value)
      path += fmt::format("M{:.1f} {:.1f}H{:.1f}", x_of(chart, at + 0.25), y_of(axis, *value), x_of(chart, at + 0.75));
    is_open = value.has_value();
  }
  return path;
}

std::string bar_path(const Chart& chart, std::size_t which, const ChartAxis& axis) {
  const double gap = chart.slots.size() <= kMostBarsWithGaps ? 0.1 : 0.0;
  std::string path;
  for (std::size_t slot = 0; slot < chart.slots.size(); ++slot) {
    double below = 0.0;
    for (std::size_t i = 0; i < which; ++i) below += std::max(value_at(chart.series[i], slot).value_or(0.0), 0.0);
    const double value = value_at(chart.series[which], slot).value_or(0.0);
    if (value <= 0.0) continue;
    const double left = x_of(chart, static_cast<double>(slot) + gap),
                 right = x_of(chart, static_cast<double>(slot) + 1.0 - gap);
    path +=
        fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}Z", left, y_of(axis, below), right, y_of(axis, below + value), left);
  }
  return path;
}

std::string number_text(double value, double step) {
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * step ? 0.0 : value, std::min(digits, 9));
}

/// A line a figure.
std::string tip_of(const Chart& chart, std::size_t slot) {
  std::string html = "Frame " + escaped(chart.slots[slot]);
  for (const ChartSeries& series : chart.series)
    if (const auto value = value_at(series, slot))
      html += fmt::format("&#10;{}: {:.4g} {}", escaped(series.name), *value, escaped(chart.unit));
  return html;
}

/// Rectangles that cannot be seen until they are pointed at.
std::string tips_svg(const Chart& chart) {
  const std::size_t each = (chart.slots.size() + kMostTips - 1) / kMostTips;
  std::string svg;
  for (std::size_t slot = 0; slot < chart.slots.size(); slot += each) {
    const double left = x_of(chart, static_cast<double>(slot));
    const double right = x_of(chart, static_cast<double>(std::min(slot + each, chart.slots.size())));
    svg += fmt::format("<rect class=\"tip\" x=\"{:.1f}\" y=\"0\" width=\"{:.1f}\" height=\"{}\"><title>{}</title></rect>", left,
                       right - left, kHeight, tip_of(chart, slot));
  }
  return svg;
}

std::string across_svg(std::string_view style, const ChartAxis& axis, double value) {
  return fmt::format("<path class=\"{}\" d=\"M0 {:.1f}H{}\"/>", style, y_of(axis, value), kWidth);
}

std::string svg_of(const Chart& chart, const ChartAxis& axis) {
  std::string svg =
      fmt::format("<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" aria-hidden=\"true\">", kWidth, kHeight);
  for (double value = axis.low; value <= axis.high + 1e-9 * axis.step; value += axis.step)
    svg += across_svg("grid", axis, value);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const ChartSeries& series = chart.series[i];
    const std::string path = chart.is_stacked ? bar_path(chart, i, axis) : line_path(chart, series, axis);
    if (!path.empty())
      svg += fmt::format("<path class=\"{} c{}\" d=\"{}\"/>", chart.is_stacked ? "bar" : "line", series.color, path);
  }
  for (const ChartLevel& level : chart.levels) svg += across_svg("level", axis, level.value);
  return svg + tips_svg(chart) + "</svg>";
}

std::string labels_up(const Chart& chart, const ChartAxis& axis) {
  std::string html = "<div class=\"up\" aria-hidden=\"true\">";
  for (double value = axis.low; value <= axis.high + 1e-9 * axis.step; value += axis.step)
    html +=
        fmt::format("<span style=\"bottom:{:.2f}%\">{}</span>", 100.0 * height_of(axis, value), number_text(value, axis.step));
  html += "</div><div class=\"names\">";
  for (const ChartLevel& level : chart.levels)
    html += fmt::format("<span style=\"bottom:{:.2f}%\">{}</span>", 100.0 * height_of(axis, level.value), escaped(level.name));
  return html + "</div>";
}

/// At most six, the first and the last among them.
std::string labels_across(const Chart& chart) {
  const std::size_t last = chart.slots.size() - 1, parts = std::min<std::size_t>(last, 5);
  std::string html = "<div class=\"across\" aria-hidden=\"true\">";
  for (std::size_t i = 0; i <= parts; ++i) {
    const std::size_t slot = parts == 0 ? 0 : i * last / parts;
    html += fmt::format("<span style=\"left:{:.2f}%\">{}</span>", 100.0 * x_of(chart, static_cast<double>(slot) + 0.5) / kWidth,
                        escaped(chart.slots[slot]));
  }
  return html + "</div>";
}

std::string legend_html(const Chart& chart) {
  std::string html;
  for (const ChartSeries& series : chart.series)
    html += fmt::format("<li class=\"c{}\">{}</li>", series.color, escaped(series.name));
  return "<ul class=\"legend\">" + html + "</ul>";
}

/// What those hear who do not see the plot.
std::string spoken(const Chart& chart) {
  std::string text = fmt::format("{} ({}) of {} frames", chart.title, chart.unit, chart.slots.size());
  for (const ChartSeries& series : chart.series) {
    Span span;
    for (std::size_t slot = 0; slot < chart.slots.size(); ++slot)
      if (const auto value = value_at(series, slot)) span.add(*value);
    if (!span.is_empty()) text += fmt::format("; {}: {:.4g} to {:.4g}", series.name, span.low, span.high);
  }
  return text;
}

}  // namespace

ChartAxis chart_axis(const Chart& chart) {
  Span span = span_of(chart);
  if (span.is_empty()) return {};
  if (chart.top) span.high = *chart.top;
  if (span.high - span.low < 1e-9 * std::max(1.0, std::abs(span.high))) span.high += std::max(1.0, 0.1 * std::abs(span.high));
  const double step = step_for(span.high - span.low);
  const double high = chart.top ? *chart.top : step * std::ceil(span.high / step - 1e-9);
  return {step * std::floor(span.low / step + 1e-9), high, step};
}

std::string chart_html(const Chart& chart) {
  if (chart.slots.empty() || !has_values(chart)) return {};
  const ChartAxis axis = chart_axis(chart);
  return fmt::format(
      "<figure class=\"chart\"><figcaption><b>{}</b> <span>{}</span></figcaption>{}{}"
      "<div class=\"plot\" role=\"img\" aria-label=\"{}\">{}{}{}</div></figure>\n",
      escaped(chart.title), escaped(chart.unit), chart.note.empty() ? "" : "<p class=\"note\">" + chart.note + "</p>",
      legend_html(chart), escaped(spoken(chart)), labels_up(chart, axis), svg_of(chart, axis), labels_across(chart));
}

std::string charts_html(const std::vector<Chart>& charts) {
  std::string html;
  for (const Chart& chart : charts) html += chart_html(chart);
  return html.empty() ? html : "<div class=\"charts\">" + html + "</div>";
}

}  // namespace lippmann
