// Renders path-traced frames in full and with reuse, and holds both against converged references: time, error, flicker, memory.
//
// CPU seconds of rendering alone, of all threads, the first frame of the reuse, which has nothing to go by, included. Full
// frames and reused ones are rendered in turn, so that each finds the machine as the others do. Where only some frames are
// compared, the reuse renders all of them, and the full render those: what it would take for all is its mean times their
// number.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/light_figures.hpp"
#include "job/params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"

namespace lippmann::bench {

struct LightCase {
  std::string name;                ///< the row's
  std::string scene;               ///< as people call it
  bool still = false;              ///< one frame: all that can be reused lies in other directions
  RenderParams params;             ///< for paths, at the samples of the full render
  int first = 0, count = 1;        ///< frames
  std::function<Scene()> build{};  ///< makes the scene; empty: the parameters name it
  int reference_spp = 2048;
  int row_share = 32;      ///< one panel row of so many is compared
  int reference_step = 1;  ///< one frame of so many is compared, the first one and the last one among them where it divides
                           ///< count - 1. The others are rendered with reuse alone
  bool equal_time = true;  ///< full renders of fewer samples are measured too
};

struct LightSettings {
  std::filesystem::path references;
  std::filesystem::path pictures;       ///< a folder for pictures of the compared frames (light_pictures.hpp); empty: none
  bool denoise = false;                 ///< frames of both ways to render
  bool without_full = false;            ///< renders with reuse alone: figures of the full render mean nothing
  std::optional<std::uint32_t> seed{};  ///< of what is rendered with reuse; none: the row's
  std::function<void(std::string_view)> say;  ///< a line of progress; may be empty
};

/// What one way to render the frames takes and gives. Errors are those of the compared frames.
struct LightFigures {
  double seconds = 0.0;        ///< CPU, all frames; of frames that were not rendered this way, the mean of those that were
  double first_seconds = 0.0;  ///< what the first one takes
  double psnr_db = 0.0;        ///< from the mean squared error over all frames
  double block_psnr_db = 0.0;  ///< from the errors of block means
  double worst_blocks_psnr_db = 0.0, edge_psnr_db = 0.0;  ///< of the worst hundredth of blocks, and of pixels at edges
  double mean_light = 1.0;                                ///< over the reference's, linear
  double worst_psnr_db = 0.0, worst_block_psnr_db = 0.0;  ///< in the frame where each is lowest
  std::vector<double> seconds_by_frame;                   ///< for frames rendered this way
  std::vector<double> psnr_db_by_frame, block_psnr_db_by_frame, mean_light_by_frame;
  double view_flicker = 0.0, frame_flicker = 0.0;  ///< beyond the reference's, codes; not a number where there is none
  double rays = 0.0;                               ///< as seconds
};

struct LightRun {
  int width = 0, height = 0;
  int compared_frames = 0;
  std::size_t compared_pixels = 0;  ///< in a frame
  int references_rendered = 0, references_kept = 0;
  LightFigures full, reuse;
  EstimateFigures estimate;
  std::vector<std::optional<double>> estimates_db;  ///< for compared frames, by the reuse itself
  std::vector<std::optional<double>> at_least_db;   ///< and the lower bounds of their PSNR that it tells, at 95 % confidence
  std::vector<TimedQuality> full_by_spp;            ///< ascending; the full render's own samples last
  double equal_time_psnr_db = 0.0;  ///< a full render's that takes as long as the reuse, with at least 1 sample; not a
                                    ///< number where that is not measured
  double stated_bytes = 0.0;        ///< that the reuse keeps from frame to frame, as it says itself
  double grown_bytes = 0.0;         ///< resident memory, from before its first frame to the most after one of its frames
  int passed_checks = 0;            ///< frames without a sample that is not a number

  double saving() const { return 1.0 - reuse.seconds / full.seconds; }
  double time_ratio() const { return full.seconds / reuse.seconds; }
  double gain_db() const { return reuse.psnr_db - full.psnr_db; }
  double block_gain_db() const { return reuse.block_psnr_db - full.block_psnr_db; }
  double equal_time_gain_db() const { return reuse.psnr_db - equal_time_psnr_db; }
};

/// Throws Error; what is returned after context.cancelled was set means nothing.
LightRun run_light(const LightCase& wanted, const LightSettings& settings, const Context& context);

}  // namespace lippmann::bench
