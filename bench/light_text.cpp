#include "bench/light_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace lippmann::bench {
namespace {

std::string verdict(bool met) { return met ? "met" : "MISSED"; }

std::string line_of(const std::string& what, const std::string& full, const std::string& reuse, const std::string& bar) {
  return fmt::format("  {:<28} {:>12} {:>12}   {}\n", what, full, reuse, bar);
}

std::string saving_bar(const LightRun& run, const std::optional<LightBar>& bar) {
  std::string saved = fmt::format("saved {:.1f} %, x{:.2f}", 100.0 * run.saving(), run.time_ratio());
  if (!bar) return saved;
  return fmt::format("{}; bar {:.0f} %: {}", saved, 100.0 * bar->saving, verdict(run.saving() >= bar->saving));
}

/// "; bar not below the full render's: met", or nothing where nothing is asked.
std::string gain_verdict(double gain_db, const std::optional<double>& least_db) {
  if (!least_db) return "";
  const std::string asked = *least_db < 0.0 ? fmt::format("not more than {:.1f} dB below", -*least_db) : "not below";
  return fmt::format("; bar {} the full render's: {}", asked, verdict(gain_db >= *least_db));
}

std::string gain_bar(const LightRun& run, const std::optional<LightBar>& bar) {
  const std::string gain = fmt::format("{:+.2f} dB", run.gain_db());
  return bar ? gain + gain_verdict(run.gain_db(), bar->gain_db) : gain;
}

std::string block_gain_bar(const LightRun& run, const std::optional<LightBar>& bar) {
  const std::string gain = fmt::format("{:+.2f} dB", run.block_gain_db());
  return bar ? gain + gain_verdict(run.block_gain_db(), bar->block_gain_db) : gain;
}

double percent_off(double mean_light) { return 100.0 * (mean_light - 1.0); }

std::string mean_light_bar(const LightRun& run, const std::optional<LightBar>& bar) {
  if (!bar || !bar->mean_light) return "";
  const double off = std::max(std::abs(run.reuse.mean_light - 1.0), std::abs(run.reuse.mean_light / run.full.mean_light - 1.0));
  return fmt::format("bar within {:.1f} % of the reference's and of the full render's: {}", 100.0 * *bar->mean_light,
                     verdict(off <= *bar->mean_light));
}

/// Nothing where the program estimates no error.
std::string estimate_line(const EstimateFigures& estimate) {
  if (!std::isfinite(estimate.mean_db)) return "";
  return line_of("PSNR by its own estimate, dB", "", fmt::format("{:.2f}", estimate.mean_db),
                 fmt::format("{:+.2f} dB beside the true one, at most {:.2f} off; within {:.1f} dB in {} of {} frames",
                             estimate.mean_excess_db, estimate.largest_error_db, kCloseDb, estimate.close, estimate.frames));
}

std::string equal_time_bar(const LightRun& run, const std::optional<LightBar>& bar) {
  std::string gain = fmt::format("{:+.2f} dB", run.equal_time_gain_db());
  if (!bar || !bar->equal_time_gain_db) return gain;
  const double asked = *bar->equal_time_gain_db;
  return fmt::format("{}; bar {:+.0f} dB: {}", gain, asked, verdict(run.equal_time_gain_db() >= asked));
}

std::string flicker_line(const char* what, double full, double reuse) {
  if (!std::isfinite(full)) return "";
  return line_of(what, fmt::format("{:.3f}", full), fmt::format("{:.3f}", reuse),
                 "bar not above the full render's: " + verdict(reuse <= full));
}

std::string memory_bar(const LightRun& run) {
  std::string stated = fmt::format("states {:.1f}", 1e-6 * run.stated_bytes);
  if (run.width * run.height > kMemoryBarPixels) return stated;
  return fmt::format("{}; bar {:.0f}: {}", stated, 1e-6 * kMemoryBar,
                     verdict(std::max(run.grown_bytes, run.stated_bytes) <= kMemoryBar));
}

}  // namespace

std::string light_text(const LightCase& wanted, const LightRun& run, const std::optional<LightBar>& bar) {
  const LightFigures &full = run.full, &reuse = run.reuse;
  const double frames = wanted.count;
  const auto per_frame = [&](const char* format, double value) { return fmt::format(fmt::runtime(format), value / frames); };
  const std::string compared = run.compared_frames == wanted.count ? "each" : fmt::format("{} of them", run.compared_frames);
  std::string text = fmt::format("{}: {} of {} x {} pixels; {} pixels of {} against {} samples\n", wanted.name,
                                 wanted.still ? "one still quilt" : fmt::format("{} frames", wanted.count), run.width,
                                 run.height, run.compared_pixels, compared, wanted.reference_spp);
  text += line_of("", fmt::format("full, {} spp", samples_per_pixel(wanted.params.sampling)), "reuse", "");
  text += line_of("CPU seconds per frame", per_frame("{:.3f}", full.seconds), per_frame("{:.3f}", reuse.seconds),
                  saving_bar(run, bar));
  text += line_of("  of the first frame", fmt::format("{:.3f}", full.first_seconds), fmt::format("{:.3f}", reuse.first_seconds),
                  "counted");
  text += line_of("PSNR, dB", fmt::format("{:.2f}", full.psnr_db), fmt::format("{:.2f}", reuse.psnr_db), gain_bar(run, bar));
  if (std::isfinite(run.equal_time_psnr_db))
    text += line_of("  full in the reuse's time", fmt::format("{:.2f}", run.equal_time_psnr_db), "", equal_time_bar(run, bar));
  const auto both = [&](const char* what, const char* format, double of_full, double of_reuse, const std::string& note) {
    text += line_of(what, fmt::format(fmt::runtime(format), of_full), fmt::format(fmt::runtime(format), of_reuse), note);
  };
  both("PSNR of 8 x 8 means, dB", "{:.2f}", full.block_psnr_db, reuse.block_psnr_db, block_gain_bar(run, bar));
  both("  of their worst hundredth", "{:.2f}", full.worst_blocks_psnr_db, reuse.worst_blocks_psnr_db, "");
  both("PSNR of pixels at edges, dB", "{:.2f}", full.edge_psnr_db, reuse.edge_psnr_db, "");
  both("mean light, % off", "{:+.3f}", percent_off(full.mean_light), percent_off(reuse.mean_light), mean_light_bar(run, bar));
  both("PSNR of the worst frame, dB", "{:.2f}", full.worst_psnr_db, reuse.worst_psnr_db, "");
  both("  of 8 x 8 means", "{:.2f}", full.worst_block_psnr_db, reuse.worst_block_psnr_db, "");
  text += estimate_line(run.estimate);
  text += flicker_line("flicker of views, codes", full.view_flicker, reuse.view_flicker);
  text += flicker_line("flicker of frames, codes", full.frame_flicker, reuse.frame_flicker);
  text += line_of("million rays per frame", per_frame("{:.2f}", 1e-6 * full.rays), per_frame("{:.2f}", 1e-6 * reuse.rays), "");
  text += line_of("MB beyond a full render", "", fmt::format("{:.1f}", 1e-6 * run.grown_bytes), memory_bar(run));
  return text + "\n";
}

}  // namespace lippmann::bench
