#include "compare/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "compare/metric_columns.hpp"
#include "core/json_text.hpp"
#include "core/printable.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> if_finite(std::optional<double> value) { return value && std::isfinite(*value) ? value : std::nullopt; }

Json to_json(const ChannelErrors& e) { return {{"r", e.r}, {"g", e.g}, {"b", e.b}, {"mean", e.mean}}; }
Json to_json(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string csv_number(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }

/// Returns whether JSON and CSV have a column for the metric. They have one for each metric that is always computed, and for
/// each metric that has a value in some frame.
bool is_written(const MetricColumn& column, const Comparison& comparison) {
  return column.is_chosen({}) || column.key == "psnr_y_db" || column.key == "psnr_yuv_db" ||
         std::any_of(comparison.frames.begin(), comparison.frames.end(), [&](const FrameComparison& frame) {
           return column.key == "flip" ? frame.metrics.flip.has_value() : frame.metrics.ms_ssim.has_value();
         });
}

template <class Value>
void add_columns(Json& json, const Comparison& comparison, const Value& value_of) {
  for (const MetricColumn& column : metric_columns())
    if (is_written(column, comparison)) json[std::string(column.key)] = to_json(value_of(column));
}

Json consistency_json(const std::vector<FrameConsistency>& frames) {
  Json list = Json::array();
  for (const FrameConsistency& frame : frames)
    list.push_back({{"name", frame.name},
                    {"angular_psnr_db", to_json(if_finite(frame.angular_psnr_db))},
                    {"flicker", to_json(if_finite(frame.flicker))}});
  return list;
}

std::string table_cell(const MetricColumn& column, std::optional<double> value) {
  return fmt::format(" {:>9}", value ? fmt::format("{:.{}f}", *value, column.digits) : "-");
}

std::string error_cells(int width, const std::string& name, const ChannelErrors& mse, double rmse) {
  return fmt::format("{:<{}}  {:>10.4f} {:>10.4f} {:>10.4f} {:>10.4f} {:>9.4f}", printable_line(name), width, mse.r, mse.g,
                     mse.b, mse.mean, rmse);
}

std::string consistency_table(const std::vector<FrameConsistency>& frames) {
  std::string text;
  for (const FrameConsistency& frame : frames) {
    const auto angular = if_finite(frame.angular_psnr_db), flicker = if_finite(frame.flicker);
    text += printable_line(frame.name) + ":";
    if (frame.angular_psnr_db) text += angular ? fmt::format("  angular PSNR {:.4f} dB", *angular) : "  angular PSNR -";
    if (flicker) text += fmt::format("  flicker {:.4f}", *flicker);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json frames = Json::array();
  for (const FrameComparison& frame : comparison.frames) {
    Json json{{"name", frame.name}, {"mse", to_json(frame.metrics.mse)}, {"rmse", to_json(frame.metrics.rmse)}};
    add_columns(json, comparison, [&](const MetricColumn& column) { return column.of(frame.metrics); });
    frames.push_back(std::move(json));
  }
  Json mean{{"mse", to_json(comparison.mean_mse)}, {"rmse", to_json(comparison.mean_rmse)}};
  add_columns(mean, comparison, [&](const MetricColumn& column) { return mean_of(column, comparison); });
  Json worst = Json::object();
  add_columns(worst, comparison, [&](const MetricColumn& column) { return worst_of(column, comparison); });
  Json whole{{"frames", frames}, {"mean", mean}, {"worst", worst}};
  if (!comparison.consistency.empty()) whole["consistency"] = consistency_json(comparison.consistency);
  whole["identical"] = comparison.identical;
  return json_to_text(whole) + "\n";
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "name,mse_r,mse_g,mse_b,mse_mean,rmse_r,rmse_g,rmse_b,rmse_mean";
  for (const MetricColumn& column : metric_columns())
    if (is_written(column, comparison)) text += fmt::format(",{}", column.key);
  text += "\n";
  for (const FrameComparison& frame : comparison.frames) {
    const PictureMetrics& m = frame.metrics;
    text += fmt::format("{},{},{},{},{},{},{},{},{}", quoted(frame.name), m.mse.r, m.mse.g, m.mse.b, m.mse.mean, m.rmse.r,
                        m.rmse.g, m.rmse.b, m.rmse.mean);
    for (const MetricColumn& column : metric_columns())
      if (is_written(column, comparison)) text += fmt::format(",{}", csv_number(column.of(m)));
    text += "\n";
  }
  return text;
}

std::string comparison_table(const Comparison& comparison, const MetricChoice& choice) {
  std::size_t longest = 5;
  for (const FrameComparison& frame : comparison.frames) longest = std::max(longest, frame.name.size());
  const int width = static_cast<int>(longest);
  std::string text =
      fmt::format("{:<{}}  {:>10} {:>10} {:>10} {:>10} {:>9}", "frame", width, "MSE R", "MSE G", "MSE B", "MSE mean", "RMSE");
  const auto add_cells = [&](const auto& cell_of) {
    for (const MetricColumn& column : metric_columns())
      if (column.is_chosen(choice)) text += cell_of(column);
    text += "\n";
  };
  add_cells([](const MetricColumn& column) { return fmt::format(" {:>9}", column.title); });
  for (const FrameComparison& frame : comparison.frames) {
    text += error_cells(width, frame.name, frame.metrics.mse, frame.metrics.rmse.mean);
    add_cells([&](const MetricColumn& column) { return table_cell(column, column.of(frame.metrics)); });
  }
  text += error_cells(width, "mean", comparison.mean_mse, comparison.mean_rmse.mean);
  add_cells([&](const MetricColumn& column) { return table_cell(column, mean_of(column, comparison)); });
  if (comparison.frames.size() > 1) {
    text += fmt::format("{:<{}}  {:>54}", "worst", width, "");
    add_cells([&](const MetricColumn& column) { return table_cell(column, worst_of(column, comparison)); });
  }
  text += consistency_table(comparison.consistency);
  if (comparison.identical) text += "identical\n";
  return text;
}

}  // namespace lippmann
