#include "job/shared_light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>

namespace lippmann {
namespace {

/// So many frames are named; the others are counted.
constexpr std::size_t kNamed = 5;

std::vector<FrameReport> measured_frames(const std::vector<FrameReport>& frames) {
  std::vector<FrameReport> some;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(some),
               [](const FrameReport& frame) { return frame.estimated_psnr_db && frame.estimated_block_psnr_db; });
  return some;
}

/// The first of several that are as low.
const FrameReport& lowest(const std::vector<FrameReport>& frames, std::optional<double> FrameReport::*figure) {
  return *std::min_element(frames.begin(), frames.end(),
                           [&](const FrameReport& a, const FrameReport& b) { return a.*figure < b.*figure; });
}

/// The PSNR that belongs to the mean of the squared errors.
double mean_psnr_db(const std::vector<FrameReport>& frames, std::optional<double> FrameReport::*figure) {
  double squares = 0.0;
  for (const FrameReport& frame : frames) squares += std::pow(10.0, -0.1 * (frame.*figure).value());
  return -10.0 * std::log10(squares / static_cast<double>(frames.size()));
}

/// "frames 0, 1, 2, 3, 4 and 7 more".
std::string named(const std::vector<FrameReport>& frames) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < std::min(frames.size(), kNamed); ++i) numbers.push_back(frames[i].frame);
  const std::string more = frames.size() > kNamed ? fmt::format(" and {} more", frames.size() - kNamed) : "";
  return fmt::format("{} {}{}", frames.size() == 1 ? "frame" : "frames", fmt::join(numbers, ", "), more);
}

std::string how_many_share(const std::vector<FrameReport>& frames) {
  const auto shared = static_cast<std::size_t>(
      std::count_if(frames.begin(), frames.end(), [](const FrameReport& frame) { return frame.kind == "shared"; }));
  if (frames.size() == 1) return shared == 0 ? "the frame was traced in full" : "the frame shares light";
  if (shared == 0) return "every frame was traced in full";
  return fmt::format("{} of {} frames share light{}", shared, frames.size(),
                     shared < frames.size() ? ", the others were traced in full" : "");
}

/// ", 41.2 dB at the eye"; empty where an eye sees single pixels, or nobody has measured what it sees.
std::string at_eye(const std::vector<FrameReport>& frames) {
  const auto is_measured = [](const FrameReport& frame) { return frame.estimated_psnr_at_eye_db.has_value(); };
  const auto differs = [](const FrameReport& frame) { return frame.estimated_psnr_at_eye_db != frame.estimated_psnr_db; };
  if (!std::all_of(frames.begin(), frames.end(), is_measured) || !std::any_of(frames.begin(), frames.end(), differs)) return "";
  const double worst = lowest(frames, &FrameReport::estimated_psnr_at_eye_db).estimated_psnr_at_eye_db.value();
  return fmt::format(", {:.1f} dB at {}eye", worst, frames.size() > 1 ? "worst at the " : "the ");
}

}  // namespace

std::string shared_light_sentence(const std::vector<FrameReport>& frames) {
  const std::string who = how_many_share(frames);
  const std::vector<FrameReport> measured = measured_frames(frames);
  if (measured.empty()) return who;
  const FrameReport &worst = lowest(measured, &FrameReport::estimated_psnr_db),
                    &worst_block = lowest(measured, &FrameReport::estimated_block_psnr_db);
  if (frames.size() == 1)
    return fmt::format("{}; estimated PSNR {:.1f} dB{} ({:.1f} dB averaged over blocks of 64 pixels)", who,
                       *worst.estimated_psnr_db, at_eye(measured), *worst_block.estimated_block_psnr_db);
  return fmt::format(
      "{}; estimated PSNR {:.1f} dB on average, {:.1f} dB at worst (frame {}){}; averaged over blocks of 64 pixels, {:.1f} dB "
      "at "
      "worst (frame {})",
      who, mean_psnr_db(measured, &FrameReport::estimated_psnr_db), *worst.estimated_psnr_db, worst.frame, at_eye(measured),
      *worst_block.estimated_block_psnr_db, worst_block.frame);
}

std::string below_floor_sentence(const std::vector<FrameReport>& frames, double min_psnr_db, QualityAt where) {
  const bool of_eye = where == QualityAt::kEye;
  const auto told = of_eye ? &FrameReport::estimated_psnr_at_eye_db : &FrameReport::estimated_psnr_db;
  const auto at_least = of_eye ? &FrameReport::psnr_at_eye_at_least_db : &FrameReport::psnr_at_least_db;
  std::vector<FrameReport> unsure = measured_frames(frames);
  std::erase_if(unsure, [&](const FrameReport& frame) { return frame.*at_least >= min_psnr_db; });
  if (unsure.empty()) return "";
  const auto below =
      std::count_if(unsure.begin(), unsure.end(), [&](const FrameReport& frame) { return frame.*told < min_psnr_db; });
  const std::string estimates = below == 0   ? "no estimate is"
                                : below == 1 ? "1 estimate is"
                                             : fmt::format("{} estimates are", below);
  return fmt::format("{} may be below --min-psnr {:g}{} (at 95 % confidence); {} below it", named(unsure), min_psnr_db,
                     of_eye ? " at the eye" : "", estimates);
}

std::string unmeasured_sentence(const std::vector<FrameReport>& frames, double min_psnr_db) {
  std::vector<FrameReport> others = frames;
  std::erase_if(others, [](const FrameReport& frame) { return frame.estimated_psnr_db.has_value(); });
  if (others.empty()) return "";
  return fmt::format("the error of {} was not estimated, so --min-psnr {:g} is not confirmed", named(others), min_psnr_db);
}

}  // namespace lippmann
