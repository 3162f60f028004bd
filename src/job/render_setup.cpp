#include "job/render_setup.hpp"

#include <utility>

#include "core/platform.hpp"
#include "folder/claim_folder.hpp"
#include "frames/strip_maker.hpp"
#include "frames/traced_frames.hpp"
#include "job/aov_params.hpp"
#include "job/job_fingerprint.hpp"
#include "job/job_videos.hpp"
#include "job/reuse_params.hpp"
#include "job/rgbd_options.hpp"
#include "job/undo_crosstalk.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Throws for all invalid parameters that can be detected before the scene is loaded.
FrameParams checked_frame_params(const ResolvedJob& job) {
  FrameParams frame_settings = frame_params(job);
  check_floor(job.params());
  check_aovs(job.params());
  return frame_settings;
}

void check_strips_of(const RenderSetup& setup) {
  if (!setup.job.is_in_strips()) return;
  if (setup.job.is_test_pattern()) throw usage_error("strips", "the test pattern cannot be split", "1");
  check_strips(setup.frame_settings, setup.optics(), setup.job.params().strips);
}

MemoryFacts memory_facts(const RenderSetup& setup) {
  return {setup.job.params(),
          setup.frame_settings,
          setup.layout,
          film_size(setup.optics()),
          static_cast<int>(setup.parts.frames.size()),
          FrameSink::frames_in_memory(setup.pool.threads()),
          !setup.run.ranks && !setup.run.is_part(),
          setup.job.is_test_pattern() ? 1 : most_strips(setup.optics()),
          rows_around(setup.frame_settings.sampling, setup.optics())};
}

void plan_memory_of(RenderSetup& setup, const Context& context) {
  const RunParams& run = setup.run;
  const MemoryFacts facts = memory_facts(setup);
  if (setup.job.is_in_strips()) setup.join_bytes = joined_frame_bytes(facts);
  if (run.only_finished && !setup.job.is_in_strips()) return;
  const double available = run.available_memory.value_or(platform::available_memory_bytes());
  if (setup.job.is_in_strips()) {
    const bool joins = !setup.leaves_strips() || (run.ranks && run.is_first_rank());
    setup.memory = plan_strips_memory(facts, setup.job.params().strips, joins, available);
    return;
  }
  setup.memory = plan_memory(facts, available);
  const std::string sentence = sentence_of(setup.memory, facts, available);
  if (!sentence.empty() && run.is_first_rank()) context.warning(sentence);
}

/// Returns the requested folder, or the first of out/<scene name>, out/<scene name>-2, ... that does not hold another
/// render.
fs::path chosen_folder(const RenderSetup& setup) {
  const fs::path wanted = output_folder(setup.job.params());
  if (wanted == "-") throw usage_error("output", "a render writes a folder of files, not standard output", "a folder");
  if (!setup.job.output().folder.empty() || setup.run.force) return wanted;
  return free_folder(wanted, setup.fingerprint);
}

void choose_folder(RenderSetup& setup) {
  setup.folder = chosen_folder(setup);
  if (const fs::path wanted = output_folder(setup.job.params()); setup.folder != wanted) {
    setup.job = setup.job.in_folder(setup.folder);
    setup.crowded_folder = wanted;
  }
  if (setup.run.force) return require_no_other_run(setup.folder, setup.fingerprint);
  const auto differing = [&](const fs::path& job_file) { return differences(job_file, setup.job); };
  require_free_folder(setup.folder, setup.fingerprint, differing, setup.parts.of_job, names_of(setup.videos));
}

}  // namespace

RenderSetup::RenderSetup(const ResolvedJob& wanted, const RunParams& wanted_run, const Context& context,
                         std::optional<JobScene> loaded)
    : job(wanted),
      frame_settings(checked_frame_params(job)),
      run(wanted_run),
      pool(job.threads(context)),
      stage(loaded ? std::move(*loaded) : load_scene_of(job, context), job, pool),
      parts(job, frame_settings, stage.scene.timeline, run),
      layout(job.output().pictures, optics(), stage.display.get()) {
  if (!stage.array.warning.empty()) context.warning(stage.array.warning);
  layout.check_picture_size(!job.sampling().aov.empty());
  check_videos(job.output(), layout, run.is_part() || run.ranks);
  check(frame_settings, optics());
  check_strips_of(*this);
  plan_memory_of(*this, context);
  crosstalk = crosstalk_to_undo(job.params(), optics(), stage.display.get());
  if (layout.is_rgbd()) writing = rgbd_options(job.output().pictures.depth, stage, pool);
  writing.binary = job.output().pictures.binary;
  fingerprint = job_fingerprint(job, stage.scene, stage.display.get());
  if (!run.is_part()) videos = job_videos(job, layout, job.frames_per_second(stage.scene.timeline));
  choose_folder(*this);
}

bool RenderSetup::keeps_frames() const {
  return job.params().resume && (job.output().video.empty() || job.output().pictures.format == PictureFormat::kPng);
}

RenderPlan RenderSetup::plan(int kept) const {
  return {stage,
          folder,
          layout.names(),
          layout.format(),
          parts.frames,
          names_of(videos),
          job.is_in_strips() ? static_cast<int>(parts.parts.size()) : 0,
          kept,
          layout.picture_size(),
          layout.pictures_per_frame(),
          memory.bytes,
          memory.bands,
          join_bytes,
          layout.light_field() != nullptr};
}

RenderReport RenderSetup::report() const {
  RenderReport report;
  report.scene = job.scene().name;
  report.optics = optics();
  report.params = job.params();
  report.reuse = frame_settings.reuse;
  report.light = stage.light;
  report.view = stage.array.how;
  report.cut = stage.placed.cut;
  report.depth_scale = stage.placed.depth_scale;
  report.depth = shown_depth(stage.array, stage.placed.units_per_mm, report.depth_scale, report.optics);
  report.crosstalk_px = crosstalk;
  report.run.host = platform::host_name(), report.run.cpu = platform::cpu_model();
  report.run.unit = run.units ? write_units(*run.units) : std::string();
  report.run.threads = pool.threads();
  report.videos = names_of(videos);
  report.frames_per_second = job.frames_per_second(stage.scene.timeline);
  return report;
}

}  // namespace lippmann
