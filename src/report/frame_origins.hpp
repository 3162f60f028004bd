// The origin of a frame's pixels, and the time saved by reuse.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

enum class Origin { kTraced, kCopied, kInterpolated, kFilled };
/// The names of the origins, indexed by Origin.
inline constexpr std::array<std::string_view, 4> kOriginNames{"traced", "copied", "interpolated", "filled"};
using OriginShares = std::array<double, kOriginNames.size()>;

/// Returns the shares by Origin, which sum to 1. None if the frame size is unknown.
///   traced         all rays were traced for this frame
///   copied         copied from a key frame, provably unchanged (reuse copy)
///   interpolated   from the points of key frames (reuse interpolate)
///   filled         no point landed there: filled from neighbours (reuse interpolate, fill interpolate)
std::optional<OriginShares> origins_of(const FrameReport& frame, const RenderFigures& render);

/// Returns whether all pixels of the frame were traced, which is so for the kinds full and key.
bool is_traced_whole(const FrameReport& frame);

/// Returns the mean CPU seconds of fully traced frames (kinds full and key); none without such frames.
std::optional<double> traced_cpu_seconds(const RenderFigures& render);

/// Returns the saved share of the time, 1 - seconds / traced_seconds; negative if `seconds` is longer. None unless both times
/// are positive.
std::optional<double> saving(double seconds, std::optional<double> traced_seconds);

}  // namespace lippmann
