#include "job/animation.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "frames/frame_maker.hpp"
#include "job/aov_params.hpp"
#include "job/finished_frames.hpp"
#include "job/frame_sink.hpp"
#include "job/job_file.hpp"
#include "job/job_stage.hpp"
#include "job/param_text.hpp"
#include "job/render_folder.hpp"
#include "job/reuse_params.hpp"
#include "job/test_pattern.hpp"
#include "job/undo_crosstalk.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJobFile = "job.toml";
constexpr const char* kReportFile = "report.json";

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

std::vector<int> frames_to_render(const RenderParams& params, const Timeline& timeline) {
  const int last = timeline.frame_count - 1;
  const FrameRanges ranges = params.output.frames.value_or(FrameRanges{{0, last}});
  for (const FrameRange& range : ranges)
    if (range.last > last)
      throw usage_error("--frames", fmt::format("{} is outside the animation", write_frames({range})),
                        fmt::format("frames from 0 to {}", last));
  return frames_of(ranges);
}

/// Refuses what cannot succeed before hours are spent on it: frames that the machine's memory does not hold.
void require_memory(const RenderParams& params, double bytes_kept_per_pixel, const Optics& optics, bool moves_pixels,
                    int frames_at_a_time) {
  const Panel& panel = optics.panel;
  constexpr double kFilmBytes = 3 * sizeof(float), kCodeBytes = 3, kAovBytes = 3 * sizeof(float);
  const double pixels = static_cast<double>(panel.width) * panel.height;
  const double films = (moves_pixels ? 2.0 : 1.0) + (params.optics.precompensate ? 2.0 : 0.0);
  const double frame = pixels * (films * kFilmBytes + kCodeBytes +
                                 kAovBytes * static_cast<double>(params.sampling.aov.size() + params.sampling.transparent));
  const double needed = frame * frames_at_a_time + pixels * bytes_kept_per_pixel;
  const double available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (needed > available)
    throw Error("--size",
                fmt::format("frames of {}x{} pixels need {:.1f} GB of memory ({} at a time, {:.1f} GB each), this machine has "
                            "{:.1f} GB",
                            panel.width / sub_pixels_per_pixel(optics), panel.height, needed * 1e-9, frames_at_a_time,
                            frame * 1e-9, available * 1e-9));
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

/// Throws Error if it cannot be written.
void make_room_for_video(const fs::path& video, const RenderParams& params, const Panel& panel) {
  make_folder(video.parent_path());
  check_video_path(video, video_options(params, video, 25.0), panel.width, panel.height);
  remove_stale_temporaries(video.parent_path(), video.filename());
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

/// Frames are kept where the job says so; not where a video wants codes that the pictures do not hold to the bit.
bool keeps_frames(const RenderParams& params) {
  return params.resume && (params.output.video.empty() || params.output.format == PictureFormat::kPng);
}

int count_kept(const RenderParams& params, FinishedFrames& finished, const std::vector<int>& frames) {
  if (!keeps_frames(params)) return 0;
  const auto is_kept = [&](int frame) { return finished.find(frame).has_value(); };
  return static_cast<int>(std::count_if(frames.begin(), frames.end(), is_kept));
}

std::uint64_t channel_bytes(PictureFormat format, ExrPixels exr_pixels) {
  if (format == PictureFormat::kExr) return exr_pixels == ExrPixels::kFloat ? 4 : 2;
  return format == PictureFormat::kPng16 ? 2 : 1;
}

/// As said, or the first of out/<scene name>, out/<scene name>-2, ... that holds no other render.
fs::path chosen_folder(const RenderParams& params, const std::string& job, bool force, const Context& context) {
  const fs::path wanted = output_folder(params);
  if (wanted == "-")
    throw usage_error("--output", "a render is a folder of files, and standard output cannot hold one", "a folder");
  if (!params.output.folder.empty() || force) return wanted;
  fs::path folder = free_folder(wanted, job);
  if (folder != wanted)
    context.warning(fmt::format("{} holds another render, so this one is in {} (--force replaces the other, -o chooses)",
                                wanted.string(), folder.string()));
  return folder;
}

/// A job file that renders all frames that this run and those before and beside it have been asked for. One that no render has
/// written is somebody's, and stays. The run has begun.
void write_job_of_folder(const fs::path& folder, const RenderParams& params, const std::vector<int>& frames, int frame_count,
                         FinishedFrames& finished, const Context& context) {
  const fs::path file = folder / kJobFile;
  const FolderJournal journal = read_journal(folder).value_or(FolderJournal{});
  const std::vector<int>& before = finished.before().asked;
  const bool is_there = is_regular_file_there(file);
  const auto written = journal.files.find(kJobFile);
  if (is_there && (written == journal.files.end() || file_checksum(file) != written->second)) {
    if (const auto keys = differences(file, params); !keys.empty())
      context.warning(
          fmt::format("{} was not written by this render and stays, although it differs in {}; report.json has the settings",
                      file.string(), fmt::join(keys, ", ")));
    return;
  }
  if (is_there && std::includes(before.begin(), before.end(), frames.begin(), frames.end())) return;
  RenderParams whole = params;
  if (journal.asked != frames) whole.output.frames = ranges_of(journal.asked);
  if (journal.asked != frames && static_cast<int>(journal.asked.size()) == frame_count) whole.output.frames.reset();
  write_job(file, whole);
  finished.add_file(kJobFile);
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
  RenderParams params = with_scene_defaults(said);
  const FrameParams made_as = frame_params(params);
  check_floor(params);
  check_aovs(params);
  const ThreadPool pool(params.threads > 0 ? params.threads : resolved_threads(context));
  JobStage stage(params, pool, context);
  const std::vector<int> frames = frames_to_render(params, stage.scene.timeline);
  const FrameLayout layout(params, stage.placed.optics, stage.display.get());
  layout.check_picture_size(!params.sampling.aov.empty());
  require_memory(params, bytes_kept_per_pixel(made_as), stage.placed.optics, layout.moves(),
                 std::min(FrameSink::frames_in_memory(pool.threads()), static_cast<int>(frames.size())));

  check(made_as, stage.placed.optics);
  const std::optional<double> crosstalk = crosstalk_to_undo(params, stage.placed.optics, stage.display.get());

  std::vector<std::string> videos;
  for (const std::string& video : params.output.video) videos.push_back(layout.video_path(video).string());
  const std::string job = job_fingerprint(params, stage.scene, stage.display.get());
  const fs::path folder = chosen_folder(params, job, observer.force, context);
  if (folder != output_folder(params)) params.output.folder = folder.string();
  if (!observer.force) require_free_folder(folder, job, params, frames, videos);
  RenderPlan plan{stage, folder, layout.names(), frames, videos, 0, layout.picture_size()};
  if (observer.only_plan) {
    if (observer.planned) observer.planned(plan);
    return {};
  }
  if (const std::string sentence = whole_paths_sentence(params); !sentence.empty()) context.warning(sentence);
  if (stage.display && !params.output.video.empty()) warn_of_videos(*stage.display, layout, context);
  for (const std::string& video : videos) make_room_for_video(video, params, stage.placed.optics.panel);
  make_folder(folder);
  remove_stale_temporaries(folder);
  clear_folder(folder, job, frames, observer.force, context);
  FinishedFrames finished(folder, job, layout.names());
  finished.begin(frames);
  finished.remove_file(kReportFile);  // it would speak of another render
  write_job_of_folder(folder, params, frames, stage.scene.timeline.frame_count, finished, context);
  plan.kept = count_kept(params, finished, frames);

  RenderReport report;
  report.scene = params.scene.name;
  report.optics = stage.placed.optics;
  report.params = params;
  report.reuse = made_as.reuse;
  report.light = stage.light;
  report.view = stage.array.how;
  report.depth_scale = stage.placed.depth_scale;
  report.depth = shown_depth(stage.array, stage.placed.units_per_mm, report.depth_scale, report.optics);
  report.crosstalk_px = crosstalk;
  report.threads = pool.threads();
  report.videos = videos;
  const double fps = params.scene.fps > 0.0 ? params.scene.fps : stage.scene.timeline.frames_per_second;
  report.frames_per_second = fps;
  const auto maker =
      params.scene.name == kTestPattern ? make_pattern_frames(stage, pool) : make_frame_maker(stage, made_as, pool, context);
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
  if (!report.interrupted) {
    for (const std::string& video : videos) finished.begin_video(video, frames);
    sink.finish_videos();
    for (const std::string& video : videos) finished.add_video(video, frames);
  }
  report.write_seconds = sink.write_seconds();
  report.peak_memory_bytes = peak_memory_bytes();
  write_report(folder / kReportFile, report);
  finished.add_file(kReportFile);
  return report;
}

}  // namespace lippmann
