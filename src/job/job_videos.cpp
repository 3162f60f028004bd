#include "job/job_videos.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

VideoOptions video_options(const OutputParams& output, const fs::path& video, double frames_per_second) {
  VideoOptions options{.rate = frame_rate(frames_per_second), .codec = output.video_codec, .crf = output.crf};
  // The default codec of .mkv is lossless and has no quality setting.
  if (!output.video_codec && video.extension() == ".mkv") options.crf.reset();
  return options;
}

void warn_of_display(const Display& display, const FrameLayout& layout, const Context& context) {
  if (layout.quilt() && !display.video.quilts)
    context.warning(fmt::format("{} shows pictures of quilts only, no videos", display.name));
  const Vec2i size = layout.picture_size();
  if (std::max(size.x, size.y) > display.video.longest_side)
    context.warning(fmt::format("{} plays videos of up to {} pixels a side, but these have {}x{}: use a smaller `size`",
                                display.name, display.video.longest_side, size.x, size.y));
}

void make_room_for_video(const VideoFile& video, Vec2i film) {
  make_folder(video.path.parent_path());
  check_video_path(video.path, video.options, film.x, film.y);
  remove_stale_temporaries(video.path.parent_path(), video.path.filename());
}

}  // namespace

void check_videos(const OutputParams& output, const FrameLayout& layout, bool is_shared) {
  if (output.video.empty()) return;
  if (!layout.is_picture())
    throw usage_error("video", "needs a layout with one picture per frame", "`layout` quilt or integral");
  if (layout.is_rgbd() && layout.format() == PictureFormat::kExr)
    throw usage_error("video", "needs pictures that store depth as integers", "`format` png or png16");
  if (is_shared && layout.format() != PictureFormat::kPng)
    throw usage_error("video", "needs 8-bit pictures, since it is encoded from the pictures of all parts", "`format` png");
}

std::vector<VideoFile> job_videos(const ResolvedJob& job, const FrameLayout& layout, double frames_per_second) {
  std::vector<VideoFile> videos;
  for (const fs::path path : job.output().video) {
    const fs::path video = layout.video_path(path);
    videos.push_back({video, video_options(job.output(), video, frames_per_second)});
    videos.back().options.stereo = layout.stereo();
  }
  return videos;
}

std::vector<std::string> names_of(const std::vector<VideoFile>& videos) {
  std::vector<std::string> names;
  for (const VideoFile& video : videos) names.push_back(video.path.string());
  return names;
}

void make_room_for_videos(const std::vector<VideoFile>& videos, const FrameLayout& layout, const Display* display,
                          const Context& context) {
  if (display && !videos.empty()) warn_of_display(*display, layout, context);
  for (const VideoFile& video : videos) {
    make_room_for_video(video, layout.picture_size());
    warn_of_mixed_rows(video.path, video.options, layout.picture_size(), context);
  }
}

void finish_videos(const std::vector<VideoFile>& videos, const std::vector<int>& frames, FrameSink& sink,
                   RenderFolder& folder) {
  std::optional<RenderFolder> whole;
  if (const fs::path path = videos.empty() ? fs::path() : folder_of_whole(folder.path()); !path.empty())
    whole.emplace(path, read_journal(path).value_or(FolderJournal{}).job);
  std::vector<RenderFolder*> folders{&folder};
  if (whole) folders.insert(folders.begin(), &*whole);
  for (RenderFolder* each : folders)
    for (const VideoFile& video : videos) each->begin_video(video.path, frames);
  const bool have_side_files = sink.finish_videos();
  for (RenderFolder* each : folders)
    for (const VideoFile& video : videos) each->add_video(video.path, frames, have_side_files);
}

}  // namespace lippmann
