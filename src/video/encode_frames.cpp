#include "video/encode_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "core/background.hpp"
#include "core/folder_entries.hpp"
#include "core/recorded_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/light_field_source.hpp"
#include "formats/quad_name.hpp"
#include "formats/rgbd_name.hpp"
#include "formats/rgbd_side_file.hpp"
#include "image/read_image.hpp"
#include "layout/oriented.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/quilt_name.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

using Series = std::map<int, fs::path>;

struct SeriesNames {
  fs::path folder;
  TextPattern name;  ///< groups: text before the number, the number, text after it
};

std::string escaped(const std::string& text) {
  std::string expression;
  for (const char letter : text) {
    if (std::string_view(R"(.^$|()[]{}*+?\)").find(letter) != std::string_view::npos) expression += '\\';
    expression += letter;
  }
  return expression;
}

SeriesNames names_of(const std::string& from) {
  std::error_code ignored;
  if (fs::is_directory(from, ignored))
    return {
        from,
        TextPattern(
            R"((.*?)([0-9]{1,9})((?:_qs[^.]*(?:\.[0-9]+)?[^.]*|_(?:half_)?(?:2x1|ou)(?:_rl)?|_rows(?:_rl)?|_rgbd)?\.(?:png|exr|jpg|jpeg|tif|tiff|ppm|bmp|tga|webp)))",
            TextPattern::Letters::kEitherCase)};
  static const TextPattern number(R"(\*|%0?[0-9]*d)");
  const fs::path path(from);
  const std::string name = path.filename().string();
  const auto found = number.search(name);
  if (!found)
    throw Error(from, "is neither a folder nor a pattern of names",
                "a folder, or a pattern such as frame_%04d.png or 'frame_*.png'");
  const std::string before = name.substr(0, found->begin), after = name.substr(found->end);
  if (number.search(after)) throw Error(from, "has two placeholders for the number of a frame", "one * or %04d");
  return {path.parent_path().empty() ? fs::path(".") : path.parent_path(),
          TextPattern(fmt::format("({})([0-9]{{1,9}})({})", escaped(before), escaped(after)))};
}

std::map<std::string, Series> series_in(const SeriesNames& names) {
  std::map<std::string, Series> all;
  for (const fs::directory_entry& entry : entries_of(names.folder)) {
    const std::string name = entry.path().filename().string();
    const auto found = names.name.match(name);
    if (!found) continue;
    const std::string& digits = found->groups[2];
    int number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const auto [at, is_new] = all[found->groups[1] + "*" + found->groups[3]].emplace(number, entry.path());
    if (!is_new)
      throw Error(names.folder.string(),
                  fmt::format("has two pictures for frame {}: {} and {}", number, at->second.filename().string(), name));
  }
  return all;
}

/// If there are several series, chooses frame_..., the default name of rendered frames.
const Series& chosen_series(const std::string& from, const std::map<std::string, Series>& all) {
  if (all.empty()) throw Error(from, "contains no frames", "frame_0000.png, frame_0001.png, ...");
  if (all.size() == 1) return all.begin()->second;
  std::vector<std::string> names, frames;
  for (const auto& [name, series] : all) {
    names.push_back(name);
    if (name.starts_with("frame_")) frames.push_back(name);
  }
  if (frames.size() == 1) return all.at(frames.front());
  throw Error(from,
              fmt::format("holds several series of pictures: {}, {}{}", names[0], names[1], names.size() > 2 ? ", ..." : ""),
              "a pattern that matches one series");
}

std::optional<RgbdSideFile> common_side_file(const std::vector<NumberedFrame>& frames) {
  const std::optional<RgbdSideFile> first = read_rgbd_side_file(frames.front().path);
  const auto is_alike = [&](const NumberedFrame& frame) { return read_rgbd_side_file(frame.path) == first; };
  return std::all_of(frames.begin(), frames.end(), is_alike) ? first : std::nullopt;
}

}  // namespace

std::vector<NumberedFrame> find_frames(const std::string& from, std::vector<int> wanted) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(from, ignored);
  if (wanted.empty() && is_folder) require_recorded_frames(from);
  const SeriesNames names = names_of(is_folder ? folder_of_pictures(from).string() : from);
  if (wanted.empty() && !is_folder) require_recorded_frames(names.folder);
  const std::map<std::string, Series> all = series_in(names);
  const Series& series = chosen_series(from, all);
  const int begin = series.begin()->first, end = series.rbegin()->first;
  if (wanted.empty()) {
    // Lists at most one number more than there are files, so that the loop is short even if the largest number is huge.
    for (int number = begin; wanted.size() <= series.size() && number <= end; ++number) wanted.push_back(number);
  }
  std::vector<NumberedFrame> frames;
  for (const int number : wanted) {
    const auto found = series.find(number);
    if (found == series.end())
      throw Error(from, fmt::format("frame {} is missing", number),
                  fmt::format("all frames from {} to {}, or `frames` with frames that exist", begin, end));
    frames.push_back({number, found->second});
  }
  return frames;
}

std::optional<StereoLayout> stereo_of(const std::vector<NumberedFrame>& frames) {
  return frames.empty() ? std::nullopt : parse_stereo_name(frames.front().path);
}

fs::path video_path(const fs::path& out, const std::vector<NumberedFrame>& frames) {
  if (const std::optional<StereoLayout> stereo = stereo_of(frames)) return with_stereo_name(out, *stereo);
  if (!frames.empty() && has_quad_name(frames.front().path)) return with_quad_name(out);
  if (!frames.empty() && has_rgbd_name(frames.front().path) && !has_half_rgbd_name(frames.front().path))
    return with_rgbd_name(out);
  const std::optional<QuiltName> quilt = frames.empty() ? std::nullopt : parse_quilt_name(frames.front().path);
  return quilt && !parse_quilt_name(out) ? with_quilt_name(out, *quilt) : out;
}

void describe_depth_of(const std::vector<NumberedFrame>& frames, const fs::path& out, const Context& context) {
  if (frames.empty() || !has_rgbd_name(frames.front().path)) return;
  if (const std::optional<RgbdSideFile> side = common_side_file(frames)) return write_rgbd_side_file(out, *side);
  std::error_code ignored;
  fs::remove(rgbd_side_path(out), ignored);  // an earlier video may have left a side file
  context.warning(
      fmt::format("The side files of the frames differ, so equal greys mean different depths, and {} gets no side file. Make "
                  "the frames with one `depth-range`.",
                  out.string()));
}

bool encode_frames(const std::vector<NumberedFrame>& frames, const fs::path& out, const VideoOptions& options,
                   const Context& context, const std::function<void(const NumberedFrame&)>& encoded, int turn_deg) {
  VideoWriter writer(out, options);
  const int threads = std::clamp(resolved_threads(context), 1, 8);
  BackgroundQueue queue(threads, threads + 1);
  for (const NumberedFrame& frame : frames) {
    if (context.cancelled) break;
    const auto picture = std::make_shared<Image8>();
    queue.submit([picture, &frame, &context,
                  turn_deg] { *picture = std::get<Image8>(oriented(read_image8(frame.path, context.warn), false, turn_deg)); },
                 [picture, &frame, &writer, &encoded] {
                   writer.add_frame(*picture);
                   if (encoded) encoded(frame);
                 });
  }
  queue.finish();
  if (context.cancelled) return false;
  writer.finish();
  return true;
}

}  // namespace lippmann
