#include "bench/light_json.hpp"

#include <cmath>

namespace lippmann::bench {
namespace {

using Json = nlohmann::ordered_json;

double to_digits(double value) { return std::round(value * 1e4) / 1e4; }

Json number(double value) { return std::isfinite(value) ? Json(to_digits(value)) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json estimates(const std::vector<std::optional<double>>& values) {
  Json list = Json::array();
  for (const std::optional<double>& value : values) list.push_back(value ? number(*value) : Json(nullptr));
  return list;
}

Json by_spp(const std::vector<TimedQuality>& measured) {
  Json list = Json::array();
  for (const TimedQuality& m : measured)
    list.push_back({{"spp", m.spp}, {"cpu_seconds", number(m.seconds)}, {"psnr_db", number(m.psnr_db)}});
  return list;
}

/// At least; null: nothing is asked.
Json bar_json(const std::optional<LightBar>& bar) {
  if (!bar) return nullptr;
  const auto asked = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  return {{"saving_total", bar->saving},
          {"gain_db", asked(bar->gain_db)},
          {"equal_time_gain_db", asked(bar->equal_time_gain_db)},
          {"block_gain_db", asked(bar->block_gain_db)},
          {"mean_light", asked(bar->mean_light)}};
}

}  // namespace

Json light_json(const LightCase& wanted, const LightRun& run, const std::optional<LightBar>& bar) {
  const LightFigures &full = run.full, &reuse = run.reuse;
  return {{"row", wanted.name},
          {"scene", wanted.scene},
          {"case", wanted.still ? "still quilt" : "animation"},
          {"width", run.width},
          {"height", run.height},
          {"frames", wanted.count},
          {"compared_frames", run.compared_frames},
          {"reference_step", wanted.reference_step},
          {"spp", samples_per_pixel(wanted.params.sampling)},
          {"reference_spp", wanted.reference_spp},
          {"compared_pixels", run.compared_pixels},
          {"references_rendered", run.references_rendered},
          {"references_kept", run.references_kept},
          {"full_cpu_seconds", number(full.seconds)},
          {"cpu_seconds", number(reuse.seconds)},
          {"first_frame_cpu_seconds", number(reuse.first_seconds)},
          {"time_ratio", number(run.time_ratio())},
          {"saving_total", number(run.saving())},
          {"full_psnr_db", number(full.psnr_db)},
          {"psnr_db", number(reuse.psnr_db)},
          {"gain_db", number(run.gain_db())},
          {"full_block_psnr_db", number(full.block_psnr_db)},
          {"block_psnr_db", number(reuse.block_psnr_db)},
          {"block_gain_db", number(run.block_gain_db())},
          {"full_worst_blocks_psnr_db", number(full.worst_blocks_psnr_db)},
          {"worst_blocks_psnr_db", number(reuse.worst_blocks_psnr_db)},
          {"full_edge_psnr_db", number(full.edge_psnr_db)},
          {"edge_psnr_db", number(reuse.edge_psnr_db)},
          {"full_mean_light", number(full.mean_light)},
          {"mean_light", number(reuse.mean_light)},
          {"full_worst_psnr_db", number(full.worst_psnr_db)},
          {"worst_psnr_db", number(reuse.worst_psnr_db)},
          {"full_worst_block_psnr_db", number(full.worst_block_psnr_db)},
          {"worst_block_psnr_db", number(reuse.worst_block_psnr_db)},
          {"said_psnr_db", number(run.estimate.mean_db)},
          {"said_excess_db", number(run.estimate.mean_excess_db)},
          {"said_error_db", number(run.estimate.largest_error_db)},
          {"said_frames", run.estimate.frames},
          {"said_within_half_db", run.estimate.close},
          {"said_psnr_db_by_frame", estimates(run.estimates_db)},
          {"cpu_seconds_by_frame", numbers(reuse.seconds_by_frame)},
          {"full_psnr_db_by_frame", numbers(full.psnr_db_by_frame)},
          {"psnr_db_by_frame", numbers(reuse.psnr_db_by_frame)},
          {"full_block_psnr_db_by_frame", numbers(full.block_psnr_db_by_frame)},
          {"block_psnr_db_by_frame", numbers(reuse.block_psnr_db_by_frame)},
          {"full_mean_light_by_frame", numbers(full.mean_light_by_frame)},
          {"mean_light_by_frame", numbers(reuse.mean_light_by_frame)},
          {"full_by_spp", by_spp(run.full_by_spp)},
          {"equal_time_psnr_db", number(run.equal_time_psnr_db)},
          {"equal_time_gain_db", number(run.equal_time_gain_db())},
          {"full_view_flicker", number(full.view_flicker)},
          {"view_flicker", number(reuse.view_flicker)},
          {"full_frame_flicker", number(full.frame_flicker)},
          {"frame_flicker", number(reuse.frame_flicker)},
          {"full_rays", std::llround(full.rays)},
          {"rays", std::llround(reuse.rays)},
          {"stated_bytes", number(run.stated_bytes)},
          {"grown_bytes", number(run.grown_bytes)},
          {"bar", bar_json(bar)}};
}

}  // namespace lippmann::bench
