#include "replay/video_views.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/platform.hpp"
#include "formats/view_files.hpp"
#include "layout/picture_samples.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Decodes all frames, because the length in a container is often wrong or missing.
int count_frames(const fs::path& video) {
  VideoReader reader(video);
  int count = 0;
  while (reader.next()) ++count;
  return count;
}

int wanted_views(const fs::path& video, const FormatOptions& options, int frames) {
  if (frames < 2)
    throw Error(video.string(), fmt::format("it has {}", frames == 0 ? "no frames" : "only one frame"),
                "a video with two or more frames, which are the views");
  const ViewGrid grid = options.views.value_or(ViewGrid{frames, 1});
  if (grid.rows != 1 || grid.columns < 2)
    throw usage_error("views", "frames of a video are one row of views",
                      fmt::format("Nx1: N frames spread over the video, from 2 to {}", frames));
  if (grid.columns > frames)
    throw usage_error("views", fmt::format("{} has only {} frames", video.string(), frames), fmt::format("up to {}x1", frames));
  return grid.columns;
}

}  // namespace

LightField read_video_views(const fs::path& video, const FormatOptions& options) {
  const int frames = count_frames(video), views = wanted_views(video, options, frames);
  LightField field;
  field.grid = {views, 1};
  VideoReader reader(video);
  int view = 0;
  for (int frame = 0; view < views; ++frame) {
    std::optional<Image8> read = reader.next();
    if (!read) throw Error(video.string(), "the file changed while it was read");
    // Takes the frame nearest to view * (frames - 1) / (views - 1).
    if (frame != (2 * view * (frames - 1) + views - 1) / (2 * (views - 1))) continue;
    Picture picture = *std::move(read);
    const Vec2d size(size_of(picture));
    if (options.fit_view) picture = options.fit_view(std::move(picture), size.x / size.y, view, field.grid);
    if (view == 0) {
      field.view_size = size_of(picture);
      field.aspect = static_cast<double>(field.view_size.x) / field.view_size.y;
      require_stack_fits(video.string(), views, field.view_size, 1, platform::available_memory_bytes());
      field.stack = blank(picture, stack_size(field));
    }
    if (size_of(picture) != field.view_size)
      throw Error(video.string(), fmt::format("frame {} has another size than the others", frame), "frames of one size");
    set_view(field, view++, picture);
  }
  return field;
}

}  // namespace lippmann
