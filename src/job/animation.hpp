// Renders an animation into a folder: frames in order, each traced while the ones before it are encoded and written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/frame_ranges.hpp"
#include "distribute/ranks.hpp"
#include "distribute/units.hpp"
#include "job/params.hpp"
#include "job/report.hpp"
#include "layout/frame_names.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

struct JobStage;

/// What is going to be done, once set-up has succeeded.
struct RenderPlan {
  const JobStage& stage;
  std::filesystem::path folder;
  FrameNames names;
  PictureFormat format = PictureFormat::kPng;
  std::vector<int> frames;               ///< ascending: those of the unit that is rendered, or all
  std::vector<std::string> videos = {};  ///< files
  int strips = 0;  ///< that `frames` are rendered in, those of the unit that is rendered; 0: they are rendered whole
  int kept = 0;    ///< how many of `frames`, or of their strips, the same job has finished before
  Vec2i picture_size{0, 0};
  int pictures_per_frame = 1;
  double memory_bytes = 0.0;  ///< that frames take beside the scene, about (memory_plan.hpp)
  int bands = 1;              ///< that frames are rendered in, as whole ones would take more memory than there is
  double join_bytes = 0.0;    ///< that joining a frame from strips takes, about; 0: none is joined
};

/// Bytes of all pictures of a plan before compression: more than what PNG and EXR files take. Layers and videos are not
/// counted; job/size_estimate.hpp says what files are likely to take.
std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels);

/// Hears how a render goes. All functions may be empty; all but `written` are called in the thread that called
/// render_animation.
struct RenderObserver {
  std::function<void(const RenderPlan&)> planned;
  std::function<void(const FrameReport&)> traced;  ///< a frame, or a strip of one, in order; its files follow
  /// A frame's pictures and layers, or a strip, are on disk, of so many bytes; in order, one at a time, on any thread. Not of
  /// what is kept, and not of frames that are joined from strips.
  std::function<void(int frame, std::uintmax_t bytes)> written;
};

/// What one run does of a job.
struct RunParams {
  bool force = false;  ///< another render in the folder is replaced, and videos that are there (folder/claim_folder.hpp)
  std::optional<Units> units = {};              ///< none: all frames. Videos wait until all are there (finish_animation)
  std::optional<FrameRanges> only_frames = {};  ///< renders these alone; the job's or units' others are asked for all the same
  /// Picks frames of the job, which comes with its segment (frames_per_segment), once the scene is loaded; empty: `units` and
  /// `only_frames` do. Where frames are rendered in strips, parts of the job instead (parts_of): they are not joined.
  std::function<std::vector<int>(const std::vector<int>& of_job, int segment)> choose = {};
  Ranks* ranks = nullptr;                       ///< that share the frames out among them; null: this process stands alone
  bool only_finished = false;                   ///< no frame is rendered: all have been, or it is an Error
  std::optional<double> available_memory = {};  ///< bytes; none: what this machine has (core/available_memory.hpp)
};

/// Writes into output_folder(params): the pictures, the videos, job.toml and report.json. The same pictures and videos, byte
/// for byte, for any number of threads, and whether or not the render was interrupted and resumed.
///
/// Where frames are rendered in strips (RenderParams::strips), runs of units, and of ranks, leave strips in the folder; whoever
/// renders whole frames, or has all of a unit's made (only_finished), joins them.
///
/// When context.cancelled is set, it stops at the next chance: finished frames stay, the frame under way and videos leave
/// nothing, report.json says `interrupted`. Throws Error for bad params or scenes (before any file is made) and for files that
/// cannot be written; the frames finished until then stay, for --resume.
RenderReport render_animation(const RenderParams& params, const Context& context, const RenderObserver& observer = {},
                              const RunParams& run = {});

/// What render_animation would do, as far as set-up tells it; frames that it would keep are not looked for. Writes nothing.
/// Throws Error as it does.
void plan_animation(const RenderParams& params, const Context& context, const RunParams& run,
                    const std::function<void(const RenderPlan&)>& planned);

}  // namespace lippmann
