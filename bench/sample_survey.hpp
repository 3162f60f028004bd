// Counts which segments of a frame's samples pass boxes around what moves to the next frame: samples none of whose segments
// does would have the same light again. An upper bound of what keeping samples over time can save.
//
// Samples of both kinds that shared light takes: those that gather a pixel's light, and whole paths. Shadow segments count up
// to the light, even where something that stands still blocks them, as in `--reuse copy`.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "device/touched_blocks.hpp"
#include "trace/shot.hpp"

namespace lippmann::bench {

enum class SampleKind {
  kGather,  ///< ends at diffuse surfaces, where point-like lights, lamps that have a size and the sun are asked for; follows
            ///< gloss
  kPaths,   ///< at every surface one light of all, and a path onwards
};

enum class SegmentClass { kCamera, kMirror, kBounce, kToPoint, kToRound, kToSun, kToLamp, kToSky, kEnd };
inline constexpr std::size_t kSegmentClasses = static_cast<std::size_t>(SegmentClass::kEnd);

struct SegmentCount {
  std::uint64_t all = 0, untouched = 0;
};

struct SampleSurvey {
  std::array<SegmentCount, kSegmentClasses> segments{};
  SegmentCount samples;  ///< untouched: none of their segments meets a box
  SegmentCount rays;     ///< untouched: those of untouched samples
  /// Untouched samples that follow no mirror or gloss, and their rays: those that another eye would see, too.
  std::uint64_t seen_alike = 0, rays_seen_alike = 0;

  const SegmentCount& of(SegmentClass segment) const { return segments[static_cast<std::size_t>(segment)]; }
};

struct SurveyParams {
  SampleKind kind = SampleKind::kGather;
  int spp = 1;
  int max_depth = 6;
  std::uint32_t frame = 0;  ///< decides the random numbers
};

/// Surveys the whole frame, on the calling thread. The device was made for Integrator::kPath.
SampleSurvey survey_samples(const Shot& shot, const std::vector<HorizonBox>& boxes, const SurveyParams& params);

}  // namespace lippmann::bench
