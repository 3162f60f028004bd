// How the pixels of a frame were made (their origin: traced, copied, interpolated or filled), and the time saved by reuse.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "report/render_figures.hpp"

namespace lippmann {

enum class Origin { kTraced, kCopied, kInterpolated, kFilled };
inline constexpr std::array<std::string_view, 4> kOriginNames{"traced", "copied", "interpolated", "filled"};
using OriginShares = std::array<double, kOriginNames.size()>;

/// Returns the fraction of pixels of each Origin, or nullopt if the frame size is unknown.
///   traced         pixels whose rays were all traced for this frame
///   copied         pixels copied from a key frame because they provably do not change (reuse copy)
///   interpolated   pixels made from the points of key frames (reuse interpolate)
///   filled         pixels without a point, filled from neighbours (reuse interpolate, fill interpolate)
std::optional<OriginShares> origins_of(const FrameReport& frame, const RenderFigures& render);

/// Returns whether all pixels of the frame were traced: its kind is full or key.
bool is_traced_whole(const FrameReport& frame);

std::optional<double> traced_cpu_seconds(const RenderFigures& render);

/// Returns 1 - seconds / traced_seconds, which may be negative, or nullopt unless both times are positive.
std::optional<double> saving(double seconds, std::optional<double> traced_seconds);

}  // namespace lippmann
