#include "job/animation.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/available_memory.hpp"
#include "core/cpu_model.hpp"
#include "core/host_name.hpp"
#include "core/json_text.hpp"
#include "folder/claim_folder.hpp"
#include "folder/frame_sink.hpp"
#include "folder/kept_lease.hpp"
#include "folder/render_folder.hpp"
#include "folder/strips.hpp"
#include "frames/banded_frames.hpp"
#include "frames/frame_maker.hpp"
#include "frames/picture_check.hpp"
#include "frames/traced_frames.hpp"
#include "job/aov_params.hpp"
#include "job/folder_documents.hpp"
#include "job/job_fingerprint.hpp"
#include "job/job_folder.hpp"
#include "job/job_stage.hpp"
#include "job/memory_plan.hpp"
#include "job/render_checks.hpp"
#include "job/reuse_params.hpp"
#include "job/rgbd_options.hpp"
#include "job/stripped_frames.hpp"
#include "job/test_pattern.hpp"
#include "job/undo_crosstalk.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/core/version.hpp"
#include "optics/optics_json.hpp"
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

/// What can be refused before a scene is loaded.
FrameParams checked_frame_params(const RenderParams& params) {
  FrameParams made_as = frame_params(params);
  check_floor(params);
  check_aovs(params);
  return made_as;
}

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

/// Frames are kept where the job says so; not where a video wants codes that the pictures do not hold to the bit.
bool keeps_frames(const RenderParams& params) {
  return params.resume && (params.output.video.empty() || params.output.pictures.format == PictureFormat::kPng);
}

std::uint64_t channel_bytes(PictureFormat format, ExrPixels exr_pixels) {
  if (format == PictureFormat::kExr) return exr_pixels == ExrPixels::kFloat ? 4 : 2;
  return format == PictureFormat::kPng16 ? 2 : 1;
}

/// As it is asked for, or the first of out/<scene name>, out/<scene name>-2, ... that holds no other render.
fs::path chosen_folder(const RenderParams& params, const std::string& job, bool force) {
  const fs::path wanted = output_folder(params);
  if (wanted == "-") throw usage_error("output", "a render writes a folder of files, not standard output", "a folder");
  if (!params.output.folder.empty() || force) return wanted;
  return free_folder(wanted, job);
}

/// What EXR files say of the render, for those who get them without its report.
std::vector<ExrAttribute> about_render(const std::string& scene, const Optics& optics, float depth_scale) {
  std::vector<ExrAttribute> about{{"lippmann.version", version()},
                                  {"lippmann.scene", scene},
                                  {"lippmann.optics", json_to_text(optics_json(optics), -1)},
                                  {"lippmann.depth_scale", fmt::format("{}", depth_scale)}};
  if (const auto rendered = rendered_views(optics)) {
    const ViewGrid& grid = rendered->film.grid;
    about.push_back({"lippmann.views", std::to_string(grid.columns) + "x" + std::to_string(grid.rows)});
  }
  return about;
}

/// Parts of frames that are rendered in so many strips (parts_of); where that is 1, frames.
std::vector<int> parts_of_run(const RunParams& run, const std::vector<int>& of_job, int segment, int strips) {
  if (run.choose) return run.choose(of_job, segment);
  const std::vector<int> of_units = run.units ? frames_of(*run.units, of_job, segment) : of_job;
  if (!run.only_frames) return of_units;
  const std::vector<int> wanted = parts_of(frames_of(*run.only_frames), strips);
  std::vector<int> both;
  std::set_intersection(of_units.begin(), of_units.end(), wanted.begin(), wanted.end(), std::back_inserter(both));
  if (both.empty() && !of_units.empty())
    throw usage_error("only-frames", fmt::format("{} selects no frame of this render", write_frames(*run.only_frames)),
                      fmt::format("some of {}", write_frames(ranges_of(frames_of_parts(of_units, strips)))));
  return both;
}

/// Throws a usage Error for frames that cannot be rendered in strips.
void check_strips_of(const RenderParams& params, const FrameParams& made_as, const Optics& optics) {
  if (params.strips == 1) return;
  if (params.scene.name == kTestPattern) throw usage_error("strips", "the test pattern cannot be split", "1");
  check_strips(made_as, optics, params.strips);
}

/// One render_animation, in the order in which its members are called.
class Animation {
 public:
  /// Refuses what cannot be rendered. Writes nothing.
  Animation(const RenderParams& wanted, const Context& context, const RenderObserver& observer, const RunParams& run)
      : context_(context),
        observer_(observer),
        run_(run),
        params_(with_scene_defaults(wanted)),
        made_as_(checked_frame_params(params_)),
        pool_(params_.threads > 0 ? params_.threads : resolved_threads(context)),
        stage_(params_, pool_, context),
        all_frames_(frames_of_job(params_, stage_.scene.timeline)),
        parts_(parts_of_run(run, parts_of(all_frames_, params_.strips), segment(), params_.strips)),
        frames_(frames_of_parts(parts_, params_.strips)),
        layout_(params_.output.pictures, optics(), stage_.display.get()) {
    check_layout();
    job_ = job_fingerprint(params_, stage_.scene, stage_.display.get());
    if (!is_part()) plan_videos();
    folder_ = chosen_folder(params_, job_, run.force);
    wanted_folder_ = output_folder(params_);
    if (folder_ != wanted_folder_) params_.output.folder = folder_.string();
    const auto differing = [this](const fs::path& job_file) { return differences(job_file, params_); };
    if (run.force) require_no_other_run(folder_, job_);
    if (!run.force) require_free_folder(folder_, job_, differing, all_frames_, video_names());
  }

  RenderPlan plan() const {
    return {stage_,
            folder_,
            layout_.names(),
            layout_.format(),
            frames_,
            video_names(),
            is_cut() ? static_cast<int>(parts_.size()) : 0,
            0,
            layout_.picture_size(),
            layout_.pictures_per_frame(),
            memory_.bytes,
            memory_.bands,
            is_cut() ? joined_frame_bytes(memory_facts()) : 0.0};
  }

  RenderReport render() {
    if (frames_.empty())
      context_.warning(fmt::format("unit {} has no frames: the job has fewer parts", write_units(*run_.units)));
    if (run_.ranks && !is_first_rank()) run_.ranks->begin();  // once the first rank has made room
    RenderFolder folder = open_folder();
    const KeptLease lease(folder);
    RenderReport report = report_of_setup();
    if (is_first_rank()) begin_report(report, folder);
    const std::unique_ptr<FrameMaker> maker = make_maker(folder, report);
    {
      FrameSink sink(sink_settings(*maker, makes_videos() ? videos_ : std::vector<VideoFile>()), folder);
      announce(folder);
      report.run.setup_seconds = setup_.seconds();
      make_frames(*maker, sink, folder, report);
      if (makes_videos() && !report.interrupted) finish_videos(sink, folder);
      report.run.write_seconds = sink.write_seconds();
    }
    report.run.peak_memory_bytes = peak_memory_bytes();
    folder.end(report.run);
    if (run_.ranks) run_.ranks->end();
    if (!is_first_rank()) return report;
    if (run_.ranks) finish_ranks(*maker, folder, report);
    RenderReport all = write_report(report, folder);
    return run_.ranks ? all : report;
  }

 private:
  const Optics& optics() const { return stage_.placed.optics; }

  /// Whether others render the rest of the job.
  bool is_part() const { return run_.units || run_.only_frames || run_.choose; }

  /// Whether frames are rendered in strips.
  bool is_cut() const { return params_.strips > 1; }

  /// Whether strips are all that the run makes: others make the rest, or they are joined once all ranks are done.
  bool leaves_strips() const { return is_cut() && (run_.units || run_.choose || run_.ranks); }

  int segment() const { return is_cut() ? 1 : frames_per_segment(made_as_); }

  std::unique_ptr<FrameMaker> make_maker(RenderFolder& folder, RenderReport& report) {
    if (params_.scene.name == kTestPattern) return make_pattern_frames(stage_, pool_);
    if (memory_.bands > 1)
      return std::make_unique<BandedFrames>(StripMaker(stage_, made_as_, memory_.bands, pool_, context_), film_size(optics()),
                                            wanted_aovs(made_as_.sampling), context_);
    if (!is_cut()) return make_frame_maker(stage_, made_as_, pool_, context_);
    StrippedFrames::Settings settings{wanted_aovs(made_as_.sampling), film_size(optics()), keeps_frames(params_),
                                      run_.only_finished};
    settings.made = [this, &report](const FrameStrip& strip, const FrameReport& made, std::uintmax_t bytes) {
      report.run.strips[strip.frame].push_back(strip.strip);
      if (leaves_strips()) report.strips.push_back(made);
      say_strip(strip, made, bytes);
    };
    auto strips = std::make_unique<StrippedFrames>(StripMaker(stage_, made_as_, params_.strips, pool_, context_), folder,
                                                   std::move(settings), context_);
    strips_ = strips.get();
    return strips;
  }

  bool is_first_rank() const { return !run_.ranks || run_.ranks->rank() == 0; }

  /// Frames that others render come too late for a video that is written along with them.
  bool makes_videos() const { return !run_.ranks; }

  FrameSink::Settings sink_settings(FrameMaker& maker, const std::vector<VideoFile>& videos) {
    return {params_.output.pictures,
            layout_,
            optics(),
            stage_.scene.encoding,
            crosstalk_,
            videos,
            writing_,
            about_render(params_.scene.name, optics(), stage_.placed.depth_scale),
            pool_.threads(),
            [&maker](Image film) { maker.recycle(std::move(film)); },
            [this](int frame, std::uintmax_t bytes) {
              if (is_cut()) return remove_strips(folder_, frame, params_.strips);
              say_written(frame, bytes);
            }};
  }

  void say_strip(const FrameStrip& strip, const FrameReport& made, std::uintmax_t bytes) {
    if (!is_first_rank()) return run_.ranks->tell({strip.frame, made.seconds, made.rays.total(), bytes});
    if (observer_.traced) observer_.traced(made);
    if (observer_.written) observer_.written(strip.frame, bytes);
  }

  void say_written(int frame, std::uintmax_t bytes) {
    if (is_first_rank()) {
      if (observer_.written) observer_.written(frame, bytes);
      return;
    }
    const std::lock_guard lock(mutex_);
    WorkDone& done = done_[frame];
    done.bytes = bytes;
    run_.ranks->tell(done);
  }

  void say_traced(const FrameReport& frame) {
    if (is_cut()) return;  // its strips have been said
    if (is_first_rank()) {
      if (observer_.traced) observer_.traced(frame);
      return;
    }
    const std::lock_guard lock(mutex_);
    done_[frame.frame] = {frame.frame, frame.seconds, frame.rays.total(), 0};
  }

  /// What another rank has done, on the first.
  void hear(const WorkDone& done) const {
    FrameReport frame;
    frame.frame = done.frame, frame.seconds = done.seconds, frame.rays.primary = done.rays;
    if (observer_.traced) observer_.traced(frame);
    if (observer_.written) observer_.written(done.frame, done.bytes);
  }

  bool is_complete(const FolderJournal& journal) const {
    return std::all_of(frames_.begin(), frames_.end(), [&](int frame) { return journal.frames.contains(frame); });
  }

  /// What is left for the first rank once all are done.
  void finish_ranks(FrameMaker& maker, RenderFolder& folder, RenderReport& report) {
    if (is_cut() && !context_.cancelled) join_frames(maker, folder, report);
    if (is_complete(folder.now())) make_videos(maker, folder);
  }

  /// Joins the frames whose strips have all been rendered.
  void join_frames(FrameMaker& maker, RenderFolder& folder, RenderReport& report) {
    FrameSink sink(sink_settings(maker, {}), folder);
    FrameSteps steps = frame_steps(maker, sink, report);
    steps.make = [&](int frame) { return !has_strips(folder.now(), frame) || join_frame(frame, sink, report); };
    take_frames(frames_, folder, steps);
    note_precompensation(sink, report);
    std::erase_if(report.strips, [&](const FrameReport& strip) { return is_reported(strip.frame, report); });
  }

  /// Not those of a rank that was stopped.
  bool has_strips(const FolderJournal& journal, int frame) const {
    const auto strips = journal.strips.find(frame);
    return strips != journal.strips.end() && static_cast<int>(strips->second.finished.size()) == params_.strips;
  }

  bool join_frame(int frame, FrameSink& sink, RenderReport& report) {
    RenderedFrame joined = strips_->join(frame);
    report.frames.push_back(joined.report);
    report.run.frames.push_back(frame);
    sink.add(std::move(joined));
    sink.wait();
    return true;
  }

  static bool is_reported(int frame, const RenderReport& report) {
    return std::any_of(report.frames.begin(), report.frames.end(),
                       [&](const FrameReport& known) { return known.frame == frame; });
  }

  /// Makes the videos of a folder whose pictures are all finished.
  void make_videos(FrameMaker& maker, RenderFolder& folder) {
    FrameSink sink(sink_settings(maker, videos_), folder);
    for (const int frame : frames_) sink.add_kept(frame);
    sink.wait();
    finish_videos(sink, folder);
  }

  double frames_per_second() const {
    return params_.scene.fps > 0.0 ? params_.scene.fps : stage_.scene.timeline.frames_per_second;
  }

  void plan_videos() {
    for (const fs::path path : params_.output.video) {
      const fs::path video = layout_.video_path(path);
      videos_.push_back({video, video_options(params_, video, frames_per_second())});
      videos_.back().options.stereo = layout_.stereo();
    }
  }

  std::vector<std::string> video_names() const {
    std::vector<std::string> names;
    for (const VideoFile& video : videos_) names.push_back(video.path.string());
    return names;
  }

  void check_layout() {
    layout_.check_picture_size(!params_.sampling.aov.empty());
    if (!params_.output.video.empty() && !layout_.is_picture())
      throw usage_error("video", "needs a layout with one picture per frame", "`layout` quilt or integral");
    if (!params_.output.video.empty() && layout_.is_rgbd() && layout_.format() == PictureFormat::kExr)
      throw usage_error("video", "needs pictures that store depth as integers", "`format` png or png16");
    if (!params_.output.video.empty() && (is_part() || run_.ranks) && layout_.format() != PictureFormat::kPng)
      throw usage_error("video", "needs pictures of 8 bits: it is encoded from those of all parts", "`format` png");
    check(made_as_, optics());
    check_strips_of(params_, made_as_, optics());
    check_memory();
    crosstalk_ = crosstalk_to_undo(params_, optics(), stage_.display.get());
    if (layout_.is_rgbd()) writing_ = rgbd_options(params_.output.pictures.depth, stage_, pool_);
  }

  MemoryFacts memory_facts() const {
    return {params_,
            made_as_,
            layout_,
            film_size(optics()),
            static_cast<int>(frames_.size()),
            FrameSink::frames_in_memory(pool_.threads()),
            makes_videos() && !is_part(),
            params_.scene.name == kTestPattern ? 1 : most_strips(optics()),
            rows_around(made_as_.sampling, optics())};
  }

  void check_memory() {
    if (run_.only_finished && !is_cut()) return;  // no frame is rendered
    const MemoryFacts facts = memory_facts();
    const double available = run_.available_memory.value_or(available_memory_bytes());
    const bool joins = !leaves_strips() || (run_.ranks && is_first_rank());
    memory_ = is_cut() ? plan_strips_memory(facts, params_.strips, joins, available) : plan_memory(facts, available);
    const std::string sentence = is_cut() ? std::string() : sentence_of(memory_, facts, available);
    if (!sentence.empty() && is_first_rank()) context_.warning(sentence);
  }

  /// Makes room in it, and records what is going to be rendered.
  RenderFolder open_folder() {
    if (stage_.display && !videos_.empty()) warn_of_videos(*stage_.display, layout_, context_);
    for (const VideoFile& video : videos_) {
      make_room_for_video(video, layout_.picture_size());
      warn_of_mixed_rows(video.path, video.options, layout_.picture_size(), context_);
    }
    RenderFolder folder =
        open_job_folder(folder_, job_, params_, all_frames_, stage_.scene.timeline.frame_count, run_.force, context_);
    if (folder_ != wanted_folder_)
      context_.warning(fmt::format("{} holds another render, so this one is in {} (--force replaces the other, -o chooses)",
                                   wanted_folder_.string(), folder_.string()));
    return folder;
  }

  RenderReport report_of_setup() const {
    RenderReport report;
    report.scene = params_.scene.name;
    report.optics = optics();
    report.params = params_;
    report.reuse = made_as_.reuse;
    report.light = stage_.light;
    report.view = stage_.array.how;
    report.depth_scale = stage_.placed.depth_scale;
    report.depth = shown_depth(stage_.array, stage_.placed.units_per_mm, report.depth_scale, report.optics);
    report.crosstalk_px = crosstalk_;
    report.run.host = host_name(), report.run.cpu = cpu_model();
    report.run.unit = run_.units ? write_units(*run_.units) : std::string();
    report.run.threads = pool_.threads();
    report.videos = video_names();
    report.frames_per_second = frames_per_second();
    return report;
  }

  void announce(RenderFolder& folder) const {
    if (!observer_.planned) return;
    RenderPlan plan = this->plan();
    if (keeps_frames(params_)) plan.kept = kept_parts(folder);
    observer_.planned(plan);
  }

  int kept_parts(RenderFolder& folder) const {
    const FolderJournal journal = folder.now();
    return static_cast<int>(std::count_if(parts_.begin(), parts_.end(), [&](int part) {
      return is_cut() ? is_finished_part(part, params_.strips, folder, journal) : folder.find(part).has_value();
    }));
  }

  void make_frames(FrameMaker& maker, FrameSink& sink, RenderFolder& folder, RenderReport& report) {
    if (run_.ranks)
      share_frames(maker, sink, folder, report);
    else
      make_parts(parts_, maker, sink, folder, report);
    report.run.sources = maker.sources();
    sink.wait();
    note_precompensation(sink, report);
    report.interrupted = context_.cancelled || (!run_.ranks && !leaves_strips() && report.frames.size() < frames_.size());
  }

  static void note_precompensation(const FrameSink& sink, RenderReport& report) {
    for (FrameReport& frame : report.frames)
      if (const auto done = sink.precompensated().find(frame.frame); done != sink.precompensated().end())
        frame.precompensation = done->second;
  }

  /// Units that are not taken yet, one after the other, until there are no more.
  void share_frames(FrameMaker& maker, FrameSink& sink, RenderFolder& folder, RenderReport& report) {
    constexpr int kUnitsPerRank = 8;  // few enough to begin seldom, enough for ranks to end at about the same time
    const std::vector<std::vector<int>> units = units_of(parts_, segment(), kUnitsPerRank * run_.ranks->size());
    if (is_first_rank()) {
      run_.ranks->listen([this](const WorkDone& done) { hear(done); });
      run_.ranks->begin();
    }
    while (!context_.cancelled) {
      const auto unit = static_cast<std::size_t>(run_.ranks->next());
      if (unit >= units.size()) break;
      make_parts(units[unit], maker, sink, folder, report);
    }
  }

  /// Frames, or strips alone where the run leaves them.
  void make_parts(const std::vector<int>& parts, FrameMaker& maker, FrameSink& sink, RenderFolder& folder,
                  RenderReport& report) {
    if (leaves_strips()) return strips_->make_strips(parts);
    take_frames(frames_of_parts(parts, params_.strips), folder, frame_steps(maker, sink, report));
  }

  FrameSteps frame_steps(FrameMaker& maker, FrameSink& sink, RenderReport& report) {
    FrameSteps steps{keeps_frames(params_), run_.only_finished && !is_cut(), {}, {}};
    steps.keep = [&](const FrameReport& kept) {
      report.frames.push_back(kept);
      report.frames.back().kept = true;
      if (is_cut()) remove_strips(folder_, kept.frame, params_.strips);  // a run may have been killed before it did
      sink.add_kept(kept.frame);
    };
    steps.make = [&](int frame) { return make_frame(frame, maker, sink, report); };
    return steps;
  }

  /// False if it was stopped.
  bool make_frame(int frame, FrameMaker& maker, FrameSink& sink, RenderReport& report) {
    if (context_.cancelled) return false;
    std::optional<SeenShare> seen;
    if (frame == all_frames_.front() && !is_cut() && params_.scene.name != kTestPattern)
      seen = look_at_frame(stage_, frame, pool_);
    RenderedFrame rendered = maker.make(frame);
    if (context_.cancelled) return false;
    if (seen)
      if (const std::string doubt = doubt_about_picture(stage_, frame, *seen, rendered.pictures.film); !doubt.empty())
        context_.warning(doubt);
    report.frames.push_back(rendered.report);
    report.run.frames.push_back(frame);
    say_traced(report.frames.back());
    sink.add(std::move(rendered));
    if (is_cut() || memory_.one_at_a_time) sink.wait();  // one film at a time; of strips, the next are recorded after it
    return true;
  }

  void finish_videos(FrameSink& sink, RenderFolder& folder) const {
    std::optional<RenderFolder> whole;  // also records the videos of its single view, whose folder may be removed
    if (const fs::path path = videos_.empty() ? fs::path() : folder_of_whole(folder_); !path.empty())
      whole.emplace(path, read_journal(path).value_or(FolderJournal{}).job);
    std::vector<RenderFolder*> folders{&folder};
    if (whole) folders.insert(folders.begin(), &*whole);
    for (RenderFolder* each : folders)
      for (const VideoFile& video : videos_) each->begin_video(video.path, frames_);
    const bool have_side_files = sink.finish_videos();
    for (RenderFolder* each : folders)
      for (const VideoFile& video : videos_) each->add_video(video.path, frames_, have_side_files);
  }

  const Stopwatch setup_;
  const Context& context_;
  const RenderObserver& observer_;
  const RunParams& run_;
  RenderParams params_;
  FrameParams made_as_;
  const ThreadPool pool_;
  JobStage stage_;
  const std::vector<int> all_frames_;  ///< the whole job's
  const std::vector<int> parts_;       ///< this run's: frames, or parts of them (parts_of)
  const std::vector<int> frames_;      ///< of these parts
  const FrameLayout layout_;
  MemoryPlan memory_;                ///< how frames are made in the memory that there is
  std::optional<double> crosstalk_;  ///< to be undone
  FormatOptions writing_;            ///< what the format of light fields is told
  std::string job_;
  std::vector<VideoFile> videos_;
  fs::path wanted_folder_, folder_;   ///< they differ where the first holds another render and no folder was given
  StrippedFrames* strips_ = nullptr;  ///< the maker of frames that are cut
  std::mutex mutex_;                  ///< what follows
  std::map<int, WorkDone> done_;      ///< by this rank, to be told to the first
};

}  // namespace

std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels) {
  const auto pixels = static_cast<std::uint64_t>(plan.picture_size.x) * static_cast<std::uint64_t>(plan.picture_size.y);
  const auto pictures = plan.frames.size() * static_cast<std::size_t>(plan.pictures_per_frame);
  return 3 * channel_bytes(plan.format, exr_pixels) * pixels * pictures;
}

RenderReport render_animation(const RenderParams& params, const Context& context, const RenderObserver& observer,
                              const RunParams& run) {
  return Animation(params, context, observer, run).render();
}

void plan_animation(const RenderParams& params, const Context& context, const RunParams& run,
                    const std::function<void(const RenderPlan&)>& planned) {
  planned(Animation(params, context, {}, run).plan());
}

}  // namespace lippmann
