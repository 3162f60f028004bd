#include "job/animation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "core/platform.hpp"
#include "core/regular_file.hpp"
#include "folder/kept_lease.hpp"
#include "formats/frame_names.hpp"
#include "frames/banded_frames.hpp"
#include "job/camera_set_files.hpp"
#include "job/folder_documents.hpp"
#include "job/frame_loop.hpp"
#include "job/job_folder.hpp"
#include "job/job_videos.hpp"
#include "job/stripped_frames.hpp"
#include "job/test_pattern.hpp"

namespace lippmann {
namespace {

RenderFolder open_folder(const RenderSetup& setup, const Context& context) {
  make_room_for_videos(setup.videos, setup.layout, setup.stage.display.get(), context);
  RenderFolder folder = open_job_folder(setup.folder, setup.fingerprint, setup.job, setup.parts.of_job,
                                        setup.stage.scene.timeline.frame_count, setup.run.force, context);
  if (!setup.crowded_folder.empty())
    context.warning(fmt::format(
        "{} holds another render, so this render is in {} (--force replaces the other render, -o DIR sets the folder)",
        setup.crowded_folder.string(), setup.folder.string()));
  return folder;
}

std::unique_ptr<FrameMaker> whole_frames(RenderSetup& setup, const Context& context) {
  if (setup.job.is_test_pattern()) return make_pattern_frames(setup.stage, setup.pool);
  if (setup.memory.bands <= 1) return make_frame_maker(setup.stage, setup.frame_settings, setup.pool, context);
  return make_banded_frames(StripMaker(setup.stage, setup.frame_settings, setup.memory.bands, setup.pool, context),
                            film_size(setup.optics()), wanted_aovs(setup.frame_settings.sampling), context);
}

StrippedFrames stripped_frames(const Run& run, bool only_joins) {
  RenderSetup& setup = run.setup;
  return {StripMaker(setup.stage, setup.frame_settings, setup.parts.strips, setup.pool, run.context),
          run.folder,
          {wanted_aovs(setup.frame_settings.sampling), film_size(setup.optics()), setup.keeps_frames(), only_joins},
          run.progress,
          run.context};
}

int kept_parts(const RenderSetup& setup, RenderFolder& folder) {
  if (!setup.keeps_frames()) return 0;
  const FolderJournal journal = folder.now();
  const auto is_finished = [&](int part) {
    return setup.job.is_in_strips() ? is_finished_part(part, setup.parts.strips, folder, journal)
                                    : folder.find(part).has_value();
  };
  return static_cast<int>(std::count_if(setup.parts.parts.begin(), setup.parts.parts.end(), is_finished));
}

/// A part is a frame or a strip (RunParts).
void make_parts(const RenderSetup& setup, const std::vector<int>& parts, FrameLoop& loop, StrippedFrames* strips) {
  if (setup.leaves_strips()) return strips->make_strips(parts);
  loop.take(frames_of_parts(parts, setup.parts.strips));
}

/// The ranks (processes of an MPI job) claim one unit after another. A unit is a set of frames or strips.
void share_parts(const Run& run, FrameLoop& loop, StrippedFrames* strips) {
  // Starting a unit costs time. With fewer units per rank, some ranks would end much later than others.
  constexpr int kUnitsPerRank = 8;
  const RenderSetup& setup = run.setup;
  Ranks& ranks = *setup.run.ranks;
  const std::vector<std::vector<int>> units = units_of(setup.parts.parts, setup.parts.segment, kUnitsPerRank * ranks.size());
  if (setup.run.is_first_rank()) {
    run.progress.listen();
    ranks.begin();
  }
  while (!run.context.cancelled) {
    const auto unit = static_cast<std::size_t>(ranks.next());
    if (unit >= units.size()) break;
    make_parts(setup, units[unit], loop, strips);
  }
}

void report_strips(const RenderSetup& setup, const StrippedFrames& strips, RenderReport& report) {
  for (const StrippedFrames::MadeStrip& made : strips.made()) {
    report.run.strips[made.number.frame].push_back(made.number.strip);
    if (setup.leaves_strips()) report.strips.push_back(made.report);
  }
}

void make_run(const Run& run, FrameMaker& maker, StrippedFrames* strips) {
  const RenderSetup& setup = run.setup;
  RenderReport& report = run.report;
  // In an MPI job, the frames of other processes arrive too late to encode videos during the render.
  const bool writes_videos = !setup.run.ranks;
  FrameLoop loop(run, maker, writes_videos ? setup.videos : std::vector<VideoFile>());
  run.progress.planned(setup.plan(kept_parts(setup, run.folder)));
  report.run.setup_seconds = setup.seconds();
  if (setup.run.ranks)
    share_parts(run, loop, strips);
  else
    make_parts(setup, setup.parts.parts, loop, strips);
  report.run.sources = maker.sources();
  if (strips) report_strips(setup, *strips, report);
  loop.wait();
  report.interrupted =
      run.context.cancelled || (!setup.run.ranks && !setup.leaves_strips() && report.frames.size() < setup.parts.frames.size());
  if (writes_videos && !report.interrupted) loop.finish_videos();
  report.run.write_seconds = loop.write_seconds();
}

/// Returns false if the frame is already joined, because joining deletes the strips.
bool has_all_strips(const FolderJournal& journal, const std::filesystem::path& folder, int frame, int strips) {
  const auto recorded = journal.strips.find(frame);
  if (recorded == journal.strips.end()) return false;
  for (int strip = 0; strip < strips; ++strip)
    if (!recorded->second.finished.contains(strip) || !is_regular_file_there(folder / strip_name(frame, strip))) return false;
  return true;
}

/// A frame that an interrupted rank left incomplete stays in strips.
void join_frames(const Run& run) {
  const FolderJournal journal = run.folder.now();
  std::vector<int> frames;
  for (const int frame : run.setup.parts.frames)
    if (has_all_strips(journal, run.setup.folder, frame, run.setup.parts.strips) ||
        (run.setup.keeps_frames() && run.folder.find(frame)))
      frames.push_back(frame);
  StrippedFrames joined = stripped_frames(run, true);
  FrameLoop loop(run, joined, {});
  loop.take(frames);
  loop.wait();
  std::erase_if(run.report.strips, [&](const FrameReport& strip) {
    return std::any_of(run.report.frames.begin(), run.report.frames.end(),
                       [&](const FrameReport& frame) { return frame.frame == strip.frame; });
  });
}

/// Runs on the first rank, after all ranks have finished.
void finish_ranks(const Run& run, FrameMaker& maker) {
  if (run.setup.job.is_in_strips() && !run.context.cancelled) join_frames(run);
  const FolderJournal journal = run.folder.now();
  const std::vector<int>& frames = run.setup.parts.frames;
  if (!std::all_of(frames.begin(), frames.end(), [&](int frame) { return journal.frames.contains(frame); })) return;
  FrameLoop loop(run, maker, run.setup.videos);
  loop.add_kept(frames);
  loop.wait();
  loop.finish_videos();
}

}  // namespace

RenderReport render_animation(const ResolvedJob& job, const Context& context, const RenderObserver& observer,
                              const RunParams& run) {
  RenderSetup setup(job, run, context);
  return render_animation(setup, context, observer);
}

RenderReport render_animation(RenderSetup& setup, const Context& context, const RenderObserver& observer) {
  Ranks* const ranks = setup.run.ranks;
  const bool is_first = setup.run.is_first_rank();
  if (setup.parts.frames.empty())
    context.warning(
        fmt::format("unit {} has no frames: the job has fewer frames and strips than units", write_units(*setup.run.units)));
  if (!is_first) ranks->begin();  // waits until the first rank has prepared the folder
  RenderFolder folder = open_folder(setup, context);
  const KeptLease lease(folder);
  RunProgress progress(observer, ranks);
  RenderReport report = setup.report();
  if (is_first) begin_report(report, folder);
  const Run run{setup, folder, progress, report, context};
  std::optional<StrippedFrames> strips;
  if (setup.job.is_in_strips()) strips.emplace(stripped_frames(run, setup.run.only_finished));
  const std::unique_ptr<FrameMaker> whole = strips ? nullptr : whole_frames(setup, context);
  FrameMaker& maker = strips ? *strips : *whole;
  make_run(run, maker, strips ? &*strips : nullptr);
  report.run.peak_memory_bytes = platform::peak_memory_bytes();
  folder.end(report.run);
  if (ranks) ranks->end();
  if (!is_first) return report;
  if (ranks) finish_ranks(run, maker);
  if (!report.interrupted) write_camera_set_files(setup, folder);
  RenderReport all = write_report(report, folder);
  return ranks ? all : report;
}

}  // namespace lippmann
