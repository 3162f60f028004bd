#include "job/reuse_sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>

namespace lippmann {
namespace {

double pixels_of(const RenderReport& report) {
  const Vec2i film = film_size(report.optics);
  return static_cast<double>(film.x) * film.y;
}

std::string describe_copied(const RenderReport& report) {
  double reused = 0.0;
  for (const FrameReport& frame : report.frames) reused += static_cast<double>(frame.reused_pixels);
  const double all = pixels_of(report) * std::max(static_cast<double>(report.frames.size()), 1.0);
  return fmt::format("{:.1f} % of all pixels are unchanged and were copied from key frames", 100.0 * reused / all);
}

/// States the numbers of traced and interpolated frames, and the shares of missed pixels (which no projected point covers).
std::string describe_interpolated(const RenderReport& report) {
  std::uint64_t keys = report.run.sources.size(), made = 0, missed = 0, newly_visible = 0, retraced = 0;
  for (const FrameReport& frame : report.frames) {
    keys += frame.kind == "key";
    made += frame.kind == "in-between";
    missed += frame.missed_pixels, newly_visible += frame.newly_visible_pixels, retraced += frame.retraced_pixels;
  }
  const double percent = 100.0 / std::max(pixels_of(report) * static_cast<double>(made), 1.0);
  return fmt::format(
      "{} frame{} interpolated between {} traced frames; {:.2f} % of the pixels missed ({:.2f} newly visible, {:.2f} not "
      "covered) and {}",
      made, made == 1 ? "" : "s", keys, percent * static_cast<double>(missed), percent * static_cast<double>(newly_visible),
      percent * static_cast<double>(missed - newly_visible), retraced > 0 ? "retraced" : "filled");
}

struct Describe {
  const RenderReport& report;

  std::string operator()(const AutoReuse&) const { return (*this)(TraceAll{}); }
  std::string operator()(const TraceAll&) const {
    return report.frames.size() == 1 ? "the frame was traced in full" : "every frame was traced in full";
  }
  std::string operator()(const CopySettled&) const { return describe_copied(report); }
  std::string operator()(const Interpolate&) const { return describe_interpolated(report); }
};

}  // namespace

std::string reuse_sentence(const RenderReport& report) {
  return fmt::format("{}: {}", name_of(report.reuse), std::visit(Describe{report}, report.reuse));
}

std::string error_sentence(const std::vector<FrameReport>& frames) {
  const FrameReport *worst = nullptr, *least_sure = nullptr;
  for (const FrameReport& frame : frames) {
    if (frame.estimated_psnr_db && (!worst || *frame.estimated_psnr_db < *worst->estimated_psnr_db)) worst = &frame;
    if (frame.psnr_at_least_db && (!least_sure || *frame.psnr_at_least_db < *least_sure->psnr_at_least_db)) least_sure = &frame;
  }
  if (!worst) return least_sure ? fmt::format("estimated error {:.0f} dB or better", *least_sure->psnr_at_least_db) : "";
  std::string interval;
  if (worst->psnr_at_least_db && worst->psnr_at_most_db)
    interval = fmt::format(" ({:.0f} to {:.0f})", *worst->psnr_at_least_db, *worst->psnr_at_most_db);
  else if (worst->psnr_at_least_db)
    interval = fmt::format(" (at least {:.0f})", *worst->psnr_at_least_db);
  const std::string error = fmt::format("{:.0f} dB{}", *worst->estimated_psnr_db, interval);
  return frames.size() == 1 ? "estimated error " + error
                            : fmt::format("estimated error at worst {}, in frame {}", error, worst->frame);
}

}  // namespace lippmann
