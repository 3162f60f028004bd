#include "render/animation.hpp"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/folder.hpp"
#include "core/json_text.hpp"
#include "core/parallel.hpp"
#include "render/aov_params.hpp"
#include "render/denoised_frames.hpp"
#include "render/finished_frames.hpp"
#include "render/frame_maker.hpp"
#include "render/frame_sink.hpp"
#include "render/job_file.hpp"
#include "render/param_text.hpp"
#include "render/reuse_params.hpp"
#include "render/undo_crosstalk.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

std::vector<int> frames_to_render(const RenderParams& params, const Timeline& timeline) {
  const int last = timeline.frame_count - 1;
  const FrameRanges ranges = params.frames.value_or(FrameRanges{{0, last}});
  for (const FrameRange& range : ranges)
    if (range.last > last)
      throw usage_error("--frames", fmt::format("{} is outside the animation", write_frames({range})),
                        fmt::format("frames from 0 to {}", last));
  return frames_of(ranges);
}

/// Refuses what cannot succeed before hours are spent on it: frames that the machine's memory does not hold.
void require_memory(const RenderParams& params, const Optics& optics, bool moves_pixels, int frames_at_a_time) {
  const Panel& panel = optics.panel;
  constexpr double kFilmBytes = 3 * sizeof(float), kCodeBytes = 3, kAovBytes = 3 * sizeof(float);
  const double pixels = static_cast<double>(panel.width) * panel.height;
  const double films = (moves_pixels ? 2.0 : 1.0) + (params.precompensate ? 2.0 : 0.0);
  const double frame =
      pixels * (films * kFilmBytes + kCodeBytes + kAovBytes * static_cast<double>(params.aov.size() + params.transparent));
  const double needed = frame * frames_at_a_time + pixels * bytes_kept_per_pixel(params);
  const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (needed > available)
    throw Error("--size",
                fmt::format("frames of {}x{} pixels need {:.1f} GB of memory ({} at a time, {:.1f} GB each), this machine has "
                            "{:.1f} GB",
                            panel.width / sub_pixels_per_pixel(optics), panel.height, needed * 1e-9, frames_at_a_time,
                            frame * 1e-9, available * 1e-9));
}

/// Pictures in the folder that this render will not replace: after a take-over they are of other settings.
void warn_of_strangers(const fs::path& folder, const FrameNames& names, const std::vector<int>& frames,
                       const Context& context) {
  const std::string ending = fs::path(frame_name(names, 0)).extension().string();
  int strangers = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    int frame = 0;
    const std::string name = entry.path().filename().string();
    if (std::sscanf(name.c_str(), "frame_%d.", &frame) != 1 || entry.path().extension() != ending) continue;
    strangers += !std::binary_search(frames.begin(), frames.end(), frame);
  }
  if (strangers > 0)
    context.warning(fmt::format("{} holds {} pictures that another job has made and this one leaves as they are",
                                folder.string(), strangers));
}

/// What the display that is rendered for will not play.
void warn_of_videos(const Display& display, const FrameLayout& layout, const Context& context) {
  if (layout.quilt() && !display.video.quilts)
    context.warning(fmt::format("{} shows pictures of quilts only, no videos", display.name));
  const Vec2i size = layout.picture_size();
  if (std::max(size.x, size.y) > display.video.longest_side)
    context.warning(fmt::format("{} plays videos of up to {} pixels a side, these have {}x{}: --size with less", display.name,
                                display.video.longest_side, size.x, size.y));
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

/// Frames are kept where the job says so; not where a video wants codes that the pictures do not hold to the bit.
bool keeps_frames(const RenderParams& params) {
  return params.resume && (params.video.empty() || params.format == PictureFormat::kPng);
}

int count_kept(const RenderParams& params, const FinishedFrames& finished, const std::vector<int>& frames) {
  if (!keeps_frames(params)) return 0;
  const auto is_kept = [&](int frame) { return finished.find(frame).has_value(); };
  return static_cast<int>(std::count_if(frames.begin(), frames.end(), is_kept));
}

std::uint64_t channel_bytes(PictureFormat format, ExrPixels exr_pixels) {
  if (format == PictureFormat::kExr) return exr_pixels == ExrPixels::kFloat ? 4 : 2;
  return format == PictureFormat::kPng16 ? 2 : 1;
}

/// A folder that nobody has named is for trying things out: the next render replaces the last.
bool may_replace(const RenderParams& params, const RenderObserver& observer) {
  return observer.force || (params.output.empty() && !params.resume);
}

void write_report(const fs::path& file, const RenderReport& report) {
  const std::string text = json_to_text(to_json(report)) + '\n';
  write_file_atomically(file, std::as_bytes(std::span(text)));
}

}  // namespace

std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels) {
  const auto pixels = static_cast<std::uint64_t>(plan.picture_size.x) * static_cast<std::uint64_t>(plan.picture_size.y);
  const auto pictures = plan.frames.size() * static_cast<std::size_t>(std::max(1, plan.names.views));
  return 3 * channel_bytes(plan.names.format, exr_pixels) * pixels * pictures;
}

RenderReport render_animation(const RenderParams& said, const Context& context, const RenderObserver& observer) {
  const Stopwatch setup;
  const RenderParams params = with_scene_defaults(said);
  check_reuse(params);
  check_aovs(params);
  check_denoise(params);
  const ThreadPool pool(params.threads > 0 ? params.threads : resolved_threads(context));
  Stage stage(params, pool, context);
  const std::vector<int> frames = frames_to_render(params, stage.scene.timeline);
  const FrameLayout layout(params, stage.placed.optics, stage.display.get());
  layout.check_picture_size(!params.aov.empty());
  require_memory(params, stage.placed.optics, layout.moves(),
                 std::min(FrameSink::frames_in_memory(pool.threads()), static_cast<int>(frames.size())));

  check_angular_filter(params, stage.placed.optics);
  const std::optional<double> crosstalk = crosstalk_to_undo(params, stage.placed.optics, stage.display.get());

  const fs::path folder = output_folder(params);
  if (folder == "-")
    throw usage_error("--output", "a render is a folder of files, and standard output cannot hold one", "a folder");
  std::vector<std::string> videos;
  for (const std::string& video : params.video) videos.push_back(layout.video_path(video).string());
  RenderPlan plan{stage, folder, layout.names(), frames, videos, 0, layout.picture_size()};
  if (observer.only_plan) {
    if (observer.planned) observer.planned(plan);
    return {};
  }
  if (stage.display && !params.video.empty()) warn_of_videos(*stage.display, layout, context);
  for (const std::string& video : videos) {
    make_folder(fs::path(video).parent_path());
    const Panel& panel = stage.placed.optics.panel;
    check_video_path(video, video_options(params, video, 25.0), panel.width, panel.height);
    remove_stale_temporaries(fs::path(video).parent_path(), fs::path(video).filename());
  }
  make_folder(folder);
  remove_stale_temporaries(folder);
  FinishedFrames finished(folder, job_fingerprint(params, stage.scene, stage.display.get()), layout.names(),
                          may_replace(params, observer) ? OtherRender::kReplace : OtherRender::kRefuse);
  if (finished.took_over() && !observer.force)
    context.warning(fmt::format("{} held another render, which this one replaces: -o keeps it", folder.string()));
  if (!params.frames || finished.took_over() || !fs::exists(folder / "job.toml")) write_job(folder / "job.toml", params);
  fs::remove(folder / "report.json");  // it would speak of another render
  if (finished.took_over()) warn_of_strangers(folder, layout.names(), frames, context);
  plan.kept = count_kept(params, finished, frames);

  RenderReport report;
  report.scene = params.scene;
  report.optics = stage.placed.optics;
  report.params = params;
  report.light = stage.light;
  report.view = stage.array.how;
  report.depth_scale = stage.placed.depth_scale;
  report.depth = shown_depth(stage.array, stage.placed.units_per_mm, report.depth_scale, report.optics);
  report.crosstalk_px = crosstalk;
  report.threads = pool.threads();
  report.videos = videos;
  const double fps = params.fps > 0.0 ? params.fps : stage.scene.timeline.frames_per_second;
  report.frames_per_second = fps;
  const auto maker = make_frame_maker(stage, params, pool, context);
  FrameSink sink({params, folder, layout, videos, stage.scene.encoding, fps, &stage.placed.optics, stage.placed.depth_scale,
                  crosstalk, pool.threads(), [&](Image film) { maker->recycle(std::move(film)); }, observer.written},
                 finished);
  if (observer.planned) observer.planned(plan);
  report.setup_seconds = setup.seconds();

  for (const int frame : frames) {
    if (context.cancelled) break;
    if (const auto kept = keeps_frames(params) ? finished.find(frame) : std::nullopt) {
      report.frames.push_back(*kept);
      report.frames.back().kept = true;
      sink.add_kept(frame);
      continue;
    }
    RenderedFrame rendered = maker->make(frame);
    if (context.cancelled) break;
    report.frames.push_back(rendered.report);
    if (observer.traced) observer.traced(report.frames.back());
    sink.add(std::move(rendered));
  }
  report.sources = maker->sources();
  sink.wait();
  for (FrameReport& frame : report.frames)
    if (const auto done = sink.precompensated().find(frame.frame); done != sink.precompensated().end())
      frame.precompensation = done->second;
  report.interrupted = report.frames.size() < frames.size();
  if (!report.interrupted) sink.finish_videos();
  report.write_seconds = sink.write_seconds();
  report.peak_memory_bytes = peak_memory_bytes();
  write_report(folder / "report.json", report);
  return report;
}

}  // namespace lippmann
