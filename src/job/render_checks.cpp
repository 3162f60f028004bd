#include "job/render_checks.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

namespace fs = std::filesystem;

namespace {

constexpr double kFilmBytes = 3 * sizeof(float), kCodeBytes = 3, kAovBytes = 3 * sizeof(float);

double pixels_of(Vec2i film) { return static_cast<double>(film.x) * film.y; }

double layer_bytes_per_pixel(const RenderParams& params) {
  return kAovBytes * static_cast<double>(params.sampling.aov.size() + params.sampling.transparent);
}

double memory_of_this_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

double frame_bytes(const RenderParams& params, const Optics& optics, bool moves_pixels) {
  const double films = (moves_pixels ? 2.0 : 1.0) + (params.optics.precompensate ? 2.0 : 0.0);
  return pixels_of(film_size(optics)) * (films * kFilmBytes + kCodeBytes + layer_bytes_per_pixel(params));
}

void require_memory(const RenderParams& params, double bytes_kept_per_pixel, const Optics& optics, bool moves_pixels,
                    int frames_at_a_time) {
  const double frame = frame_bytes(params, optics, moves_pixels), available = memory_of_this_machine();
  const double needed = frame * frames_at_a_time + pixels_of(film_size(optics)) * bytes_kept_per_pixel;
  if (needed > available)
    throw Error(
        "size",
        fmt::format("frames of {}x{} pixels need {:.1f} GB of memory ({} at a time, {:.1f} GB each), this machine has "
                    "{:.1f} GB",
                    optics.panel.width, optics.panel.height, needed * 1e-9, frames_at_a_time, frame * 1e-9, available * 1e-9));
}

void require_memory_for_strips(const RenderParams& params, double bytes_kept_per_pixel, const Optics& optics) {
  constexpr double kCopies = 2.0;  // its file is encoded in memory
  const double pixels = pixels_of(film_size(optics)) / params.strips, available = memory_of_this_machine();
  const double needed = pixels * (kCopies * (kFilmBytes + layer_bytes_per_pixel(params)) + bytes_kept_per_pixel);
  if (needed > available)
    throw Error("strips",
                fmt::format("{} of {}x{} pixels need {:.1f} GB of memory each, this machine has {:.1f} GB", params.strips,
                            optics.panel.width, optics.panel.height, needed * 1e-9, available * 1e-9),
                "more of them");
}

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
