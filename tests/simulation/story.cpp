#include "simulation/story.hpp"

#include <fmt/core.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/frame_ranges.hpp"
#include "distribute/units.hpp"
#include "folder/claim_folder.hpp"
#include "folder/folder_check.hpp"
#include "folder/journal_writer.hpp"
#include "folder/strips.hpp"
#include "formats/frame_names.hpp"
#include "job/finish_animation.hpp"
#include "job/folder_documents.hpp"
#include "job/job_folder.hpp"
#include "lippmann/core/error.hpp"
#include "simulation/world.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJob = "0123456789abcdef";
constexpr const char* kOtherJob = "fedcba9876543210";

enum class Kind { kPicture, kLayers, kViews };
enum class Before { kNothing, kAnotherRender, kForeignFiles, kRemains };

struct Work {
  fs::path folder;
  std::optional<Units> units = {};
  bool finishes = false, force = false, only_finished = false;
  int attempts = 0;
  std::string job = kJob;
};

using FolderFrame = std::pair<fs::path, int>;
/// A folder, and the number of a strip among the strips of all frames.
using FolderPart = std::pair<fs::path, int>;

class Making {
 public:
  Making(std::multiset<FolderFrame>& all, FolderFrame own) : all_(all), own_(all.insert(std::move(own))) {}
  ~Making() { all_.erase(own_); }
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

 private:
  std::multiset<FolderFrame>& all_;
  std::multiset<FolderFrame>::iterator own_;
};

/// Bytes in place of a picture. They differ between files and jobs, and are the same in every run.
std::string picture_bytes(const std::string& name, const std::string& job = kJob) {
  Random random(std::hash<std::string>()(job == kJob ? name : job + name));
  std::string bytes(20 + random.below(200), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random.next());
  return bytes;
}

class Teller {
 public:
  explicit Teller(std::uint64_t seed)
      : shares_a_name_(seed % 5 == 4),
        strips_(seed % 3 == 2 ? 2 + static_cast<int>(seed / 3 % 3) : 1),
        world_(seed, kMachines, shares_a_name_),
        random_(world_.random) {
    kind_ = static_cast<Kind>(random_.below(3));
    const int first = static_cast<int>(random_.below(2));
    frames_ = frames_of({{{first, first + static_cast<int>(random_.below(random_.once_in(8) ? 7 : 4)), 1}}});
    segment_ = 1 + static_cast<int>(random_.below(3));
    apart_ = random_.once_in(4);
    has_video_ = random_.once_in(2);
    has_rival_ = seed % 4 == 1 && strips_ == 1 && !apart_ && !shares_a_name_;
    world_.flips = [this](const std::string& path) { return forget(path); };
  }

  Story tell() {
    try {
      prepare();
      suffer();
      recover();
      expect_all("after it was finished");
      world_.disk.lose_power(random_);
      expect_all("after power was lost at the end");
    } catch (const std::exception& error) {
      complain(error.what());
    }
    return {problem_, world_.log, static_cast<int>(frames_.size()), runs_, world_.steps};
  }

 private:
  static constexpr int kMachines = 3;

  void complain(const std::string& problem) {
    if (problem_.empty()) problem_ = fmt::format("step {}: {}", world_.steps, problem);
  }

  std::vector<std::string> names_of(int frame) const {
    const std::string picture = fmt::format("frame_{:04}", frame);
    if (kind_ == Kind::kPicture) return {picture + ".png"};
    if (kind_ == Kind::kLayers) return {picture + ".png", fmt::format("aov_{:04}.exr", frame)};
    return {picture + "/view_000.png", picture + "/view_001.png"};
  }

  std::string video_of(const fs::path& folder) const { return (folder / "film.mkv").string(); }

  RenderParams params_of(const Work& work) const {
    RenderParams params;
    params.scene.name = "teapot";
    params.output.folder = work.folder.string();
    params.output.frames = ranges_of(frames_);
    params.resume = true;
    params.strips = strips_;
    return params;
  }

  static void write(const fs::path& path, const std::string& bytes) {
    write_file_atomically(path, std::as_bytes(std::span(bytes)));
  }

  FileRecords write_frame(const Work& work, int frame) const {
    const fs::path& folder = work.folder;
    std::vector<fs::path> files;
    for (const std::string& name : names_of(frame)) {
      files.push_back(folder / name);
      if (kind_ == Kind::kViews) make_folder(files.back().parent_path()), remove_stale_temporaries(files.back().parent_path());
      write(files.back(), picture_bytes(name, work.job));
    }
    return records_of(folder, files);
  }

  void write_video(RenderFolder& folder) const {
    const fs::path video = video_of(folder.path());
    folder.begin_video(video, frames_);
    write(video, picture_bytes("film.mkv"));
    folder.add_video(video, frames_);
  }

  /// Does what render_animation() does to the folder, with a few bytes in place of each picture.
  RenderReport render(const Work& work) {
    const Context context;
    const RenderParams params = params_of(work);
    const std::vector<int> all = parts_of(frames_, strips_);
    const std::vector<int> own = work.units ? frames_of(*work.units, all, strips_ > 1 ? 1 : segment_) : all;
    const bool makes_video = has_video_ && !work.units;
    const std::vector<std::string> videos = makes_video ? std::vector{video_of(work.folder)} : std::vector<std::string>();
    if (!work.force) require_free_folder(work.folder, work.job, {}, frames_, videos);
    RenderFolder folder = open_job_folder(work.folder, work.job, ResolvedJob(params), frames_, kAllFrames, work.force, context);
    RenderReport report;
    report.params = params;
    begin_report(report, folder);
    if (strips_ > 1 && work.units)
      take_strips(own, folder, strip_steps(folder));
    else
      take_whole_frames(work, frames_of_parts(own, strips_), folder, report);
    if (makes_video) write_video(folder);
    folder.end(report.run);
    RenderReport written = write_report(report, folder);
    expect_own_frames(work, report);
    return written;
  }

  void take_whole_frames(const Work& work, const std::vector<int>& frames, RenderFolder& folder, RenderReport& report) {
    FrameSteps steps{true, work.only_finished && strips_ == 1, {}, {}};
    steps.keep = [&](const FrameReport& kept) {
      report.frames.push_back(kept);
      remove_strips_of(work.folder, kept.frame);
    };
    steps.make = [&](int frame) { return make(work, frame, folder, report); };
    take_frames(frames, folder, steps);
  }

  StripSteps strip_steps(RenderFolder& folder) {
    return {strips_, true, [this, &folder](int frame, int strip) { return make_strip(frame, strip, folder); }};
  }

  bool make_strip(int frame, int strip, RenderFolder& folder) {
    const FolderPart part{folder.path(), frame * strips_ + strip};
    expect_unfinished(finished_parts_, part, "strip");
    const Making making(being_made_, {folder.path(), frame});
    FrameReport made;
    made.frame = frame;
    const fs::path file = folder.path() / strip_name(frame, strip);
    write(file, picture_bytes(strip_name(frame, strip)));
    folder.add_strip({frame, strip, strips_}, made, records_of(folder.path(), {file}));
    if (is_alive()) finished_parts_[part] = world_.steps;
    return true;
  }

  void join_strips(int frame, const RenderFolder& folder) {
    finished_strips(folder, frame, strips_);
    for (int strip = 0; strip < strips_; ++strip) {
      const std::string name = strip_name(frame, strip);
      std::ifstream in(folder.path() / name, std::ios::binary);
      std::string bytes(1000, '\0');
      in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      if (in.bad() || in.gcount() == 0) throw Error(name, "cannot be read");
      bytes.resize(static_cast<std::size_t>(in.gcount()));
      if (bytes != picture_bytes(name) && is_alive() && !has_misread()) complain(name + " is wrong and joined");
    }
  }

  void remove_strips_of(const fs::path& folder, int frame) {
    if (strips_ == 1) return;
    forget_strips_of(folder, frame);
    remove_strips(folder, frame, strips_);
    // Another task may have finished a strip of this frame in the meantime. remove_strips() has removed this strip too.
    forget_strips_of(folder, frame);
  }

  void forget_strips_of(const fs::path& folder, int frame) {
    for (const int part : parts_of({frame}, strips_)) finished_parts_.erase({folder, part});
  }

  bool make(const Work& work, int frame, RenderFolder& folder, RenderReport& report) {
    if (strips_ > 1 && !work.only_finished) take_strips(parts_of({frame}, strips_), folder, strip_steps(folder));
    if (work.job == kJob) expect_unfinished(finished_, {work.folder, frame}, "frame");
    const Making making(being_made_, {work.folder, frame});
    if (strips_ > 1) join_strips(frame, folder);
    FrameReport made;
    made.frame = frame;
    folder.add(made, write_frame(work, frame));
    if (is_alive() && work.job == kJob) finished_[{work.folder, frame}] = world_.steps;
    remove_strips_of(work.folder, frame);
    report.frames.push_back(made), report.run.frames.push_back(frame);
    return true;
  }

  /// Finishes the job, whose frames are in one folder or in several.
  std::optional<RenderReport> finish(const Work& work) {
    std::vector<fs::path> parts;
    if (apart_)
      for (int unit = 1; unit <= units_; ++unit)
        if (world_.disk.find(part(unit).string()) >= 0) parts.push_back(part(unit));
    const std::uint64_t began = world_.steps;
    const auto result = finish_folder(work.folder, parts, [&](const RenderParams& params) {
      if (!params.output.frames || frames_of(*params.output.frames) != frames_) complain("job.toml has other frames");
      return render({.folder = work.folder, .only_finished = true});
    });
    if (result.report && is_alive() && !has_misread() && world_.last_flip < began) expect_frames(work.folder, "as finish says");
    return result.report;
  }

  bool is_alive() { return !world_.current() || !world_.current()->is_dead; }
  bool has_misread() { return world_.current() && world_.current()->has_misread; }

  /// Complains if a run renders a frame or a strip that was finished before the run started, unless the run failed to
  /// read a file.
  void expect_unfinished(const std::map<FolderFrame, std::uint64_t>& finished, const FolderFrame& thing, const char* kind) {
    const auto found = finished.find(thing);
    if (!is_alive() || has_misread() || found == finished.end() || found->second >= world_.current()->began) return;
    complain(fmt::format("{} {} was finished at step {} and is rendered again", kind, thing.second, found->second));
  }

  void expect_own_frames(const Work& work, const RenderReport& report) {
    const Process* process = world_.current();
    if (!process || process->is_dead || process->has_misread || world_.last_flip >= process->began) return;
    for (const FrameReport& frame : report.frames)
      for (const std::string& name : names_of(frame.frame))
        if (bytes_at(work.folder / name) != picture_bytes(name, work.job))
          complain(name + " is not of the job that rendered it");
  }

  bool has_strip(const FolderPart& of, int inode) const {
    return world_.disk.find((of.first / strip_name(of.second / strips_, of.second % strips_)).string()) == inode;
  }

  bool has_file(const FolderFrame& of, int inode) const {
    const auto names = names_of(of.second);
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return world_.disk.find((of.first / name).string()) == inode; });
  }

  /// Returns whether the simulation may damage a byte of the file. If so, the file no longer counts as finished. Damage
  /// to a file that is being written cannot be detected. A file may have two names, so inodes are compared.
  bool forget(const std::string& path) {
    const int inode = world_.disk.find(path);
    for (const FolderFrame& made : being_made_) {
      if (has_file(made, inode)) return false;
      for (const int part : parts_of({made.second}, strips_))
        if (strips_ > 1 && has_strip({made.first, part}, inode)) return false;
    }
    return std::erase_if(finished_, [&](const auto& entry) { return has_file(entry.first, inode); }) > 0 ||
           std::erase_if(finished_parts_, [&](const auto& entry) { return has_strip(entry.first, inode); }) > 0;
  }

  std::string bytes_at(const fs::path& path) {
    const int inode = world_.disk.find(path.string());
    return inode < 0 ? "" : world_.disk.at(inode).bytes;
  }

  void expect_frames(const fs::path& folder, const std::string& when) {
    for (const int frame : frames_)
      for (const std::string& name : names_of(frame))
        if (bytes_at(folder / name) != picture_bytes(name)) complain(fmt::format("{} is wrong {}", name, when));
    if (when == "after it was finished")
      for (const int part : parts_of(frames_, strips_))
        if (world_.disk.find((folder / strip_name(part / strips_, part % strips_)).string()) >= 0)
          complain("a strip is left " + when);
    if (has_video_ && !apart_ && when != "as finish says" && bytes_at(video_of(folder)) != picture_bytes("film.mkv"))
      complain("the video is wrong " + when);
  }

  void expect_all(const std::string& when) {
    expect_frames(folder_, when);
    const FolderCheck check = check_folder(folder_);
    if (check.passed() && check.frames == static_cast<int>(frames_.size())) return;
    std::string names;
    for (const auto* some : {&check.damaged, &check.missing, &check.foreign})
      for (const std::string& name : *some) names += ' ' + name;
    complain(fmt::format("the check does not pass {}: {} frames, {} unfinished,{}", when, check.frames, check.unfinished.size(),
                         names));
  }

  fs::path part(int unit) const { return fmt::format("/sim/part-{}", unit); }

  void prepare() {
    if (!random_.once_in(3)) return;
    const auto before = static_cast<Before>(1 + random_.below(3));
    if (before == Before::kAnotherRender) {
      world_.start(0, [&] { render({.folder = folder_, .job = kOtherJob}); });
      world_.run();
      finished_.clear(), finished_parts_.clear();
      refuse_or_replace();
    } else if (before == Before::kForeignFiles) {
      make_folder(folder_), write(folder_ / names_of(frames_.front()).front().substr(0, 10).append(".png"), "somebody's");
      refuse_or_replace();
    } else {
      make_folder(folder_ / ".lippmann");
      if (random_.once_in(2)) world_.disk.create_file("/sim/film/.lippmann/01700000000-gone-7.jsonl");
      world_.disk.create_file("/sim/film/.frame_0001.tmp-7-node0.png");
    }
  }

  void refuse_or_replace() {
    const std::string before = bytes_at(folder_ / "job.toml");
    bool is_refused = false;
    try {
      render({.folder = folder_});
    } catch (const Error&) {
      is_refused = true;
    }
    if (!is_refused || bytes_at(folder_ / "job.toml") != before) complain("another render's folder is not refused");
    if (random_.once_in(2))
      folder_ = "/sim/film-2";
    else
      world_.start(0, [&] { attempt({.folder = folder_, .units = Units{{1}, 1}, .force = true}); }), world_.run();
  }

  void choose_faults() {
    Faults& faults = world_.faults;
    const auto rate = [&](std::size_t often, std::size_t seldom) {
      return random_.once_in(3) ? 0 : often + random_.below(seldom);
    };
    faults.kill = rate(100, 2000), faults.machine_loss = rate(500, 4000), faults.power_loss = rate(500, 4000);
    faults.disk_full = rate(500, 4000), faults.error = rate(100, 2000), faults.interrupted = rate(2, 30);
    faults.read_error = random_.once_in(3) ? 200 + random_.below(2000) : 0;
    faults.clock_jump = has_rival_ ? 0 : rate(100, 2000),
    faults.flipped_byte = random_.once_in(3) ? 300 + random_.below(2000) : 0;
  }

  void queue_tasks() {
    units_ = 1 + static_cast<int>(random_.below(4));
    for (int unit = 1; unit <= units_; ++unit) {
      const Work work{.folder = apart_ ? part(unit) : folder_, .units = Units{{unit}, units_}};
      queue_.push_back(work);
      if (random_.once_in(4)) queue_.push_back(work);
    }
    if (random_.once_in(3)) queue_.push_back({.folder = folder_, .finishes = true});
    if (!apart_ && random_.once_in(3)) queue_.push_back({.folder = folder_});
    for (std::size_t i = queue_.size(); i > 1; --i) std::swap(queue_[i - 1], queue_[random_.below(i)]);
    if (has_rival_) queue_.push_front({.folder = folder_, .units = Units{{1}, 1}, .job = kOtherJob});
  }

  void suffer() {
    choose_faults();
    queue_tasks();
    const std::size_t at_a_time = has_rival_ ? 2 + random_.below(2) : 1 + random_.below(3);
    world_.run([&] {
      while (world_.running() < at_a_time && !queue_.empty()) {
        const Work work = queue_.front();
        queue_.pop_front();
        world_.start(machine_for(work), [this, work] { attempt(work); });
      }
    });
    world_.calm();
  }

  /// The competing job needs its own machine, because processes on one machine detect each other by calls that are not
  /// simulated.
  int machine_for(const Work& work) {
    if (!has_rival_) return static_cast<int>(random_.below(kMachines));
    return work.job == kJob ? static_cast<int>(random_.below(kMachines - 1)) : kMachines - 1;
  }

  /// A failed task is usually queued again, for up to four attempts.
  void attempt(Work work) {
    const bool is_done = try_to(work);
    if (++work.attempts < 4 && !is_done && !random_.once_in(4)) queue_.push_back(work);
  }

  bool try_to(const Work& work) {
    ++runs_;
    try {
      const bool is_done = work.finishes ? finish(work).has_value() : (render(work), true);
      return is_alive() && is_done;
    } catch (const Error& error) {
      if (is_alive()) world_.log += fmt::format("{}: process {}: {}\n", world_.steps, world_.current()->id, error.what());
    } catch (const std::exception& error) {
      if (is_alive()) complain(fmt::format("an exception that is no Error: {}", error.what()));
    }
    return false;
  }

  /// Renders missing frames and finishes the job when all machines work again.
  void recover() {
    if (has_rival_) world_.pass(static_cast<std::int64_t>(2e9 * kLeaseSeconds));
    if (has_rival_ && finished_.empty()) complete({.folder = folder_, .units = Units{{1}, 1}, .force = true});
    for (int round = 0; round < 2; ++round) {
      if (complete({.folder = folder_, .finishes = true})) return;
      if (apart_)
        for (int unit = 1; unit <= units_; ++unit) complete({.folder = part(unit), .units = Units{{unit}, units_}});
      else
        complete({.folder = folder_});
    }
    if (!complete({.folder = folder_, .finishes = true})) complain("the job cannot be finished");
  }

  bool complete(const Work& work) {
    bool is_done = false;
    world_.start(0, [&] { is_done = try_to(work); });
    world_.run();
    return is_done;
  }

  static constexpr int kAllFrames = 100;

  bool shares_a_name_;
  int strips_;  ///< strips per frame; 1: whole frames
  World world_;
  Random& random_;
  Kind kind_ = Kind::kPicture;
  std::vector<int> frames_;
  int segment_ = 1, units_ = 1, runs_ = 0;
  bool apart_ = false, has_video_ = false;
  bool has_rival_ = false;
  fs::path folder_ = "/sim/film";
  std::deque<Work> queue_;
  std::map<FolderFrame, std::uint64_t> finished_;
  /// Finished strips of unfinished frames, each with the simulation step at which it was finished.
  std::map<FolderPart, std::uint64_t> finished_parts_;
  std::multiset<FolderFrame> being_made_;
  std::string problem_;
};

}  // namespace

Story tell_story(std::uint64_t seed) { return Teller(seed).tell(); }

}  // namespace lippmann::test
