// Compares denoised path tracing at 16 samples per pixel with path tracing at 64 samples per pixel without denoising.
//
// The benchmark fails if a frame contains a NaN, or if the mean light of the denoised frames differs from the references by
// more than kMeanLight. It reports whether the PSNR of the denoised frames is at most kCloseDb below that of 64 samples.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>

#include "bench/benchmarks.hpp"
#include "bench/light_run.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::bench {
namespace {

const int kSamples = Integrator::kPath.facts().default_samples;
constexpr int kFullSamples = 64;
constexpr double kCloseDb = 0.3, kMeanLight = 0.005;
constexpr int kErrorGain = 4, kMidGrey = 128;

nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(std::round(value * 1e4) / 1e4) : nlohmann::ordered_json(nullptr);
}

bool is_as_good(const LightFigures& denoised, const LightFigures& full) {
  const auto reaches = [](double db, double full_db) { return std::isnan(full_db) || db >= full_db - kCloseDb; };
  return reaches(denoised.psnr_db, full.psnr_db) && reaches(denoised.edge_psnr_db, full.edge_psnr_db);
}

bool keeps_light(const LightFigures& denoised) {
  return std::isnan(denoised.mean_light) || std::abs(denoised.mean_light - 1.0) <= kMeanLight;
}

struct FigureKey {
  const char* key;
  double LightFigures::*figure;
};
constexpr FigureKey kFigureKeys[] = {
    {"cpu_seconds", &LightFigures::cpu_seconds},     {"psnr_db", &LightFigures::psnr_db},
    {"block_psnr_db", &LightFigures::block_psnr_db}, {"edge_psnr_db", &LightFigures::edge_psnr_db},
    {"mean_light", &LightFigures::mean_light},       {"view_flicker", &LightFigures::view_flicker},
    {"frame_flicker", &LightFigures::frame_flicker}};

nlohmann::ordered_json row_of(const LightCase& row, const LightBench& bench, const LightFigures& denoised,
                              const LightFigures& full) {
  nlohmann::ordered_json json{{"scene", row.name},
                              {"case", row.build       ? "hostile"
                                       : row.count > 1 ? "animation"
                                                       : "still"},
                              {"width", bench.film_size().x},
                              {"height", bench.film_size().y},
                              {"frames", row.count},
                              {"spp", kSamples},
                              {"full_spp", kFullSamples},
                              {"reference_spp", row.reference_spp},
                              {"references_rendered", bench.reference_counts().rendered()},
                              {"references_kept", bench.reference_counts().kept()},
                              {"time_ratio", number(full.cpu_seconds / denoised.cpu_seconds)},
                              {"saving_total", number(1.0 - denoised.cpu_seconds / full.cpu_seconds)}};
  for (const auto& [key, figure] : kFigureKeys) {
    json[key] = number(denoised.*figure);
    json[std::string("full_") + key] = number(full.*figure);
  }
  json["as_good"] = is_as_good(denoised, full), json["keeps_light"] = keeps_light(denoised);
  return json;
}

std::string heading() {
  return fmt::format("{:<12} {:>13} {:>6} {:>15} {:>15} {:>15} {:>15} {:>15} {:>15}\n", "scene", "CPU s a frame", "ratio",
                     "PSNR, dB", "edges, dB", "8x8 means, dB", "mean light, %", "view flicker", "frame flicker") +
         fmt::format("{:<12} {:>13}\n", "", fmt::format("{} : {} spp", kSamples, kFullSamples));
}

std::string line_of(const LightCase& row, const LightFigures& denoised, const LightFigures& full) {
  const double frames = row.count;
  const auto db = [](double a, double b) { return fmt::format("{:.2f} : {:.2f}", a, b); };
  const auto signed_pair = [](double a, double b) {
    return std::isfinite(a) && std::isfinite(b) ? fmt::format("{:+.2f} : {:+.2f}", a, b) : std::string("-");
  };
  return fmt::format("{:<12} {:>13} {:>6.2f} {:>15} {:>15} {:>15} {:>15} {:>15} {:>15}{}{}\n", row.name,
                     db(denoised.cpu_seconds / frames, full.cpu_seconds / frames), full.cpu_seconds / denoised.cpu_seconds,
                     db(denoised.psnr_db, full.psnr_db), db(denoised.edge_psnr_db, full.edge_psnr_db),
                     db(denoised.block_psnr_db, full.block_psnr_db),
                     signed_pair(100.0 * (denoised.mean_light - 1.0), 100.0 * (full.mean_light - 1.0)),
                     signed_pair(denoised.view_flicker, full.view_flicker),
                     signed_pair(denoised.frame_flicker, full.frame_flicker), is_as_good(denoised, full) ? "" : "  below",
                     keeps_light(denoised) ? "" : "  LIGHT");
}

/// Returns the amplified difference test - reference. Mid-grey means no difference.
Image8 error_picture(const Image8& reference, const Image8& test) {
  Image8 error = test;
  for (std::size_t i = 0; i < error.rgb.size(); ++i)
    error.rgb[i] = static_cast<unsigned char>(
        std::clamp(kMidGrey + kErrorGain * (static_cast<int>(test.rgb[i]) - reference.rgb[i]), 0, 255));
  return error;
}

/// Writes FOLDER/SCENE_FRAME_NAME.png, where NAME is reference, denoised, full or error. The views are stacked vertically.
void write_pictures(const std::filesystem::path& folder, const LightCase& row, const References& references,
                    const LightFigures& denoised, const LightFigures& full) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  for (std::size_t f = 0; f < references.size(); ++f) {
    const std::string stem = std::filesystem::path(row.name).stem().string();
    const auto write = [&](const char* what, const Image8& picture) {
      write_picture(folder / fmt::format("{}_{:04}_{}.png", stem, row.first + static_cast<int>(f), what), picture);
    };
    const Image8 reference = mean_of(references[f]);
    write("reference", reference);
    write("denoised", denoised.frames[f]);
    write("full", full.frames[f]);
    write("error", error_picture(reference, denoised.frames[f]));
  }
}

}  // namespace

Report measure_light(const Request& request, const Context& context) {
  Report report;
  if (request.list) {
    report.text = light_row_list();
    return report;
  }
  report.text = heading();
  for (const LightCase& row : light_cases(request, context)) {
    LightBench bench(row, request, context);
    const std::vector<LightFigures> ways = bench.measure({with_samples(row.params.sampling, kSamples, Denoise::kAuto),
                                                          with_samples(row.params.sampling, kFullSamples, Denoise::kNone)});
    report.rows.push_back(row_of(row, bench, ways[0], ways[1]));
    report.text += line_of(row, ways[0], ways[1]);
    report.passed_checks += 2 * row.count + (keeps_light(ways[0]) ? 1 : 0);
    if (!request.quick && !keeps_light(ways[0]))
      report.failed_checks.push_back(
          fmt::format("{}: mean light is {:+.2f} % off", row.name, 100.0 * (ways[0].mean_light - 1.0)));
    if (!request.pictures.empty()) write_pictures(request.pictures, row, bench.references(), ways[0], ways[1]);
  }
  return report;
}

}  // namespace lippmann::bench
