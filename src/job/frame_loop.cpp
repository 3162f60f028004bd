#include "job/frame_loop.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "core/json_text.hpp"
#include "folder/strips.hpp"
#include "frames/picture_check.hpp"
#include "job/job_folder.hpp"
#include "job/job_videos.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/version.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

/// EXR attributes for programs that read a picture without the report.
std::vector<ExrAttribute> about_render(const RenderSetup& setup) {
  std::vector<ExrAttribute> about{{"lippmann.version", version()},
                                  {"lippmann.scene", setup.job.scene().name},
                                  {"lippmann.optics", json_to_text(optics_json(setup.optics()), -1)},
                                  {"lippmann.depth_scale", fmt::format("{}", setup.stage.placed.depth_scale)}};
  if (const auto rendered = rendered_views(setup.optics())) {
    const ViewGrid& grid = rendered->film.grid;
    about.push_back({"lippmann.views", std::to_string(grid.columns) + "x" + std::to_string(grid.rows)});
  }
  return about;
}

FrameSink::Settings sink_settings(const Run& run, FrameMaker& maker, const std::vector<VideoFile>& videos) {
  const RenderSetup& setup = run.setup;
  FrameSink::Settings settings{setup.job.output().pictures,
                               setup.layout,
                               setup.optics(),
                               setup.stage.scene.encoding,
                               setup.crosstalk,
                               videos,
                               setup.writing,
                               about_render(setup),
                               setup.pool.threads(),
                               [&maker](Image film) { maker.recycle(std::move(film)); }};
  if (setup.job.scene().cameras)
    settings.one_set = OneSet{setup.stage.scene.timeline.frame_count, setup.stage.placed.units_per_mm};
  if (setup.job.is_in_strips())
    settings.written = [&setup](int frame, std::uintmax_t) { remove_strips(setup.folder, frame, setup.parts.strips); };
  else
    settings.written = [&progress = run.progress](int frame, std::uintmax_t bytes) { progress.written(frame, bytes); };
  return settings;
}

}  // namespace

FrameLoop::FrameLoop(const Run& run, FrameMaker& maker, const std::vector<VideoFile>& videos)
    : run_(run), maker_(maker), videos_(videos), sink_(sink_settings(run, maker, videos), run.folder) {}

void FrameLoop::take(const std::vector<int>& frames) {
  const RenderSetup& setup = run_.setup;
  take_frames(frames, run_.folder,
              {setup.keeps_frames(), setup.run.only_finished && !setup.job.is_in_strips(),
               [this](const FrameReport& kept) { keep(kept); }, [this](int frame) { return make(frame); }});
}

void FrameLoop::keep(const FrameReport& kept) {
  run_.report.frames.push_back(kept);
  run_.report.frames.back().kept = true;
  // An earlier run that was killed may have left strips of the finished frame.
  if (run_.setup.job.is_in_strips()) remove_strips(run_.setup.folder, kept.frame, run_.setup.parts.strips);
  sink_.add_kept(kept.frame);
}

void FrameLoop::add_kept(const std::vector<int>& frames) {
  for (const int frame : frames) sink_.add_kept(frame);
}

bool FrameLoop::make(int frame) {
  if (run_.context.cancelled) return false;
  RenderedFrame made = rendered(frame);
  if (run_.context.cancelled) return false;
  run_.report.frames.push_back(made.report);
  run_.report.run.frames.push_back(frame);
  const bool in_strips = run_.setup.job.is_in_strips();
  if (!in_strips) run_.progress.traced(made.report);
  sink_.add(std::move(made));
  if (in_strips || run_.setup.memory.one_at_a_time) sink_.wait();
  return true;
}

/// If the first frame of the job shows nothing, warns with the reason.
RenderedFrame FrameLoop::rendered(int frame) {
  RenderSetup& setup = run_.setup;
  const bool is_checked = frame == setup.parts.of_job.front() && !setup.job.is_in_strips() && !setup.job.is_test_pattern();
  const std::optional<SeenShare> seen =
      is_checked ? std::optional(look_at_frame(setup.stage, frame, setup.pool)) : std::nullopt;
  RenderedFrame made = maker_.make(frame);
  if (seen && !run_.context.cancelled)
    if (const std::string doubt = doubt_about_picture(setup.stage, frame, *seen, made.pictures.film); !doubt.empty())
      run_.context.warning(doubt);
  return made;
}

void FrameLoop::wait() {
  sink_.wait();
  for (FrameReport& frame : run_.report.frames)
    if (const auto done = sink_.precompensated().find(frame.frame); done != sink_.precompensated().end())
      frame.precompensation = done->second;
}

void FrameLoop::finish_videos() { lippmann::finish_videos(videos_, run_.setup.parts.frames, sink_, run_.folder); }

}  // namespace lippmann
