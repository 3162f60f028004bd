// Where the pixels of a frame come from, and what that saves.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

enum class Origin { kTraced, kCopied, kInterpolated, kFilled };
/// By Origin.
inline constexpr std::array<std::string_view, 4> kOriginNames{"traced", "copied", "interpolated", "filled"};
using OriginShares = std::array<double, kOriginNames.size()>;

/// Shares by Origin that add up to 1. None where the size of frames is not known.
///   traced         every ray of its own
///   copied         the bits of a key frame, provably unchanged (reuse copy)
///   interpolated   from the points of key frames (reuse interpolate)
///   filled         no point fell there: from its neighbours (reuse interpolate, fill interpolate)
std::optional<OriginShares> origins_of(const FrameReport& frame, const RenderFigures& render);

/// Of kind full or key.
bool is_traced_whole(const FrameReport& frame);

/// The mean CPU seconds of the frames that were traced whole (kinds full and key); none where there is none.
std::optional<double> traced_cpu_seconds(const RenderFigures& render);

/// 1 - seconds / traced; below 0: it took longer. None unless both are above 0.
std::optional<double> saving(double seconds, std::optional<double> traced_seconds);

}  // namespace lippmann
