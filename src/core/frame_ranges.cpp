#include "core/frame_ranges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/number_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

std::optional<FrameRange> parse_range(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view ends = text.substr(0, colon);
  const std::size_t dash = ends.find('-');
  const auto first = parse_number<int>(ends.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_number<int>(ends.substr(dash + 1));
  const auto step = colon == std::string_view::npos ? 1 : parse_number<int>(text.substr(colon + 1));
  if (!first || !last || !step || *first < 0 || *last < *first || *step < 1) return std::nullopt;
  return FrameRange{*first, *last, *step};
}

}  // namespace

std::vector<int> frames_of(const FrameRanges& ranges) {
  std::vector<int> frames;
  for (const FrameRange& range : ranges)
    for (std::int64_t frame = range.first; frame <= range.last; frame += range.step) frames.push_back(static_cast<int>(frame));
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

FrameRanges ranges_of(const std::vector<int>& frames) {
  FrameRanges ranges;
  for (const int frame : frames) {
    if (!ranges.empty() && ranges.back().last + 1 == frame)
      ranges.back().last = frame;
    else
      ranges.push_back({frame, frame});
  }
  return ranges;
}

FrameRanges read_frames(std::string_view text, const std::string& where) {
  constexpr std::int64_t kMost = 10'000'000;
  std::int64_t count = 0;
  FrameRanges ranges;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::optional<FrameRange> range = parse_range(text.substr(start, comma - start));
    if (!range)
      throw usage_error(where, fmt::format("'{}' is not a selection of frames", text),
                        "A-B with 0 <= A <= B, one frame A, every S-th as A-B:S, or several of these: 0,2,4-8,10-20:5");
    count += (std::int64_t{range->last} - range->first) / range->step + 1;
    if (count > kMost)
      throw usage_error(where, fmt::format("'{}' selects too many frames", text), fmt::format("at most {}", kMost));
    ranges.push_back(*range);
    start = comma + 1;
  }
  return ranges;
}

std::string write_frames(const FrameRanges& frames) {
  std::string text;
  for (const FrameRange& range : frames) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", range.first);
    if (range.last != range.first) text += fmt::format("-{}", range.last);
    if (range.step != 1) text += fmt::format(":{}", range.step);
  }
  return text;
}

}  // namespace lippmann
