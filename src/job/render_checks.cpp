#include "job/render_checks.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

namespace fs = std::filesystem;

void warn_of_videos(const Display& display, const FrameLayout& layout, const Context& context) {
  if (layout.quilt() && !display.video.quilts)
    context.warning(fmt::format("{} shows pictures of quilts only, no videos", display.name));
  const Vec2i size = layout.picture_size();
  if (std::max(size.x, size.y) > display.video.longest_side)
    context.warning(fmt::format("{} plays videos of up to {} pixels a side, these have {}x{}: `size` with less", display.name,
                                display.video.longest_side, size.x, size.y));
}

VideoOptions video_options(const RenderParams& params, const fs::path& video, double frames_per_second) {
  VideoOptions options{.rate = frame_rate(frames_per_second), .codec = params.output.video_codec, .crf = params.output.crf};
  if (!params.output.video_codec && video.extension() == ".mkv") options.crf.reset();  // it loses nothing
  return options;
}

void make_room_for_video(const VideoFile& video, Vec2i film) {
  make_folder(video.path.parent_path());
  check_video_path(video.path, video.options, film.x, film.y);
  remove_stale_temporaries(video.path.parent_path(), video.path.filename());
}

}  // namespace lippmann
