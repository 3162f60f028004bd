#include "compare/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/json_text.hpp"
#include "core/printable.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> if_finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

Json to_json(const ChannelErrors& e) { return {{"r", e.r}, {"g", e.g}, {"b", e.b}, {"mean", e.mean}}; }
Json to_json(std::optional<double> value) { return value ? Json(*value) : Json(nullptr); }

std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

std::string csv_number(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }

std::string table_row(int width, const std::string& name, const ChannelErrors& mse, double rmse, std::optional<double> psnr,
                      std::optional<double> ssim) {
  return fmt::format("{:<{}}  {:>10.4f} {:>10.4f} {:>10.4f} {:>10.4f} {:>9.4f} {:>9} {:>8}\n", printable_line(name), width,
                     mse.r, mse.g, mse.b, mse.mean, rmse, psnr ? fmt::format("{:.4f}", *psnr) : "-",
                     ssim ? fmt::format("{:.5f}", *ssim) : "-");
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json frames = Json::array();
  for (const FrameComparison& frame : comparison.frames)
    frames.push_back({{"name", frame.name},
                      {"mse", to_json(frame.metrics.mse)},
                      {"rmse", to_json(frame.metrics.rmse)},
                      {"psnr_db", to_json(if_finite(frame.metrics.psnr_db))},
                      {"ssim", to_json(if_finite(frame.metrics.ssim))}});
  const Json mean{{"mse", to_json(comparison.mean_mse)},
                  {"rmse", to_json(comparison.mean_rmse)},
                  {"psnr_db", to_json(comparison.mean_psnr_db)},
                  {"ssim", to_json(comparison.mean_ssim)}};
  const Json whole{{"frames", frames}, {"mean", mean}, {"identical", comparison.identical}};
  return json_to_text(whole) + "\n";
}

std::string comparison_csv(const Comparison& comparison) {
  std::string text = "name,mse_r,mse_g,mse_b,mse_mean,rmse_r,rmse_g,rmse_b,rmse_mean,psnr_db,ssim\n";
  for (const FrameComparison& frame : comparison.frames) {
    const PictureMetrics& m = frame.metrics;
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", quoted(frame.name), m.mse.r, m.mse.g, m.mse.b, m.mse.mean, m.rmse.r,
                    m.rmse.g, m.rmse.b, m.rmse.mean, csv_number(if_finite(m.psnr_db)), csv_number(if_finite(m.ssim)));
  }
  return text;
}

std::string comparison_table(const Comparison& comparison) {
  std::size_t width = 5;
  for (const FrameComparison& frame : comparison.frames) width = std::max(width, frame.name.size());
  std::string text = fmt::format("{:<{}}  {:>10} {:>10} {:>10} {:>10} {:>9} {:>9} {:>8}\n", "frame", width, "MSE R", "MSE G",
                                 "MSE B", "MSE mean", "RMSE", "PSNR dB", "SSIM");
  for (const FrameComparison& frame : comparison.frames) {
    const PictureMetrics& m = frame.metrics;
    text += table_row(static_cast<int>(width), frame.name, m.mse, m.rmse.mean, if_finite(m.psnr_db), if_finite(m.ssim));
  }
  text += table_row(static_cast<int>(width), "mean", comparison.mean_mse, comparison.mean_rmse.mean, comparison.mean_psnr_db,
                    comparison.mean_ssim);
  if (comparison.identical) text += "identical\n";
  return text;
}

}  // namespace lippmann
