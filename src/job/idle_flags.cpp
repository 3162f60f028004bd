#include "job/idle_flags.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

bool traces_paths(const RenderParams& params) { return facts_of(params.sampling).is_stochastic; }

bool interpolates(const RenderParams& params) { return params.reuse.choice == ReuseChoice::kInterpolate; }

bool has_key_frames(const RenderParams& params) {
  const ReuseChoice choice = params.reuse.choice;
  return interpolates(params) || choice == ReuseChoice::kCopy ||
         (choice == ReuseChoice::kAuto && can_copy_settled(params.sampling));
}

bool may_denoise(const RenderParams& params) { return traces_paths(params) || params.sampling.denoise == Denoise::kNone; }

bool precompensates(const RenderParams& params) { return params.optics.precompensate; }

bool makes_videos(const RenderParams& params) { return !params.output.video.empty(); }

/// FFV1, the default codec of .mkv, is lossless and has no quality setting.
bool makes_lossy_videos(const RenderParams& params) {
  if (params.output.video_codec) return makes_videos(params) && *params.output.video_codec != VideoCodec::kFfv1;
  const auto is_lossy = [](const std::string& file) { return std::filesystem::path(file).extension() != ".mkv"; };
  return std::any_of(params.output.video.begin(), params.output.video.end(), is_lossy);
}

bool makes_exr(const RenderParams& params) {
  return params.output.pictures.format == PictureFormat::kExr && params.output.pictures.layout != PictureLayout::kPrint;
}

bool writes_colmap(const RenderParams& params) { return params.output.pictures.to == "colmap"; }

bool makes_codes(const RenderParams& params) { return !makes_exr(params) || makes_videos(params); }

bool is_file(const RenderParams& params) { return !is_builtin_scene(params.scene.name); }

/// Built-in scenes have their own light. With Whitted shading, scenes from files have surroundings only if these are requested.
bool has_surroundings(const RenderParams& params) {
  if (!params.scene.environment.empty()) return params.scene.environment != "none";
  return is_file(params) && facts_of(params.sampling).is_lit_by_surroundings;
}

/// A uniform colour (scene_light.hpp) looks the same from all directions.
bool has_surroundings_to_turn(const RenderParams& params) {
  const std::string& environment = params.scene.environment;
  const bool is_colour = environment.starts_with('#') || environment.find(',') != std::string::npos;
  return has_surroundings(params) && !is_colour;
}

/// If a display is given without a kind of optics, the display may have microlenses, so the result is true.
bool has_microlenses(const RenderParams& params) {
  return optics_kind(params).info().takes_param("packing") || (!params.optics.kind && !params.optics.display.empty());
}

bool has_parallax(const RenderParams& params) { return optics_kind(params).info().has_parallax; }

/// Built-in scenes with one sample per pixel use no random numbers. A scene file may hold splats, which are rendered with
/// several samples per pixel. A set of cameras is split into training and test views at random.
bool has_random_numbers(const RenderParams& params) {
  return is_file(params) || samples_per_pixel(params.sampling) > 1 || params.scene.cameras;
}

struct Effect {
  std::string_view parameter;
  bool (*exists)(const RenderParams&);
  const char* ineffective;
  const char* accepted;
};

constexpr const char* kNotInterpolated = "without interpolated frames";
constexpr const char* kInterpolateToo = "--reuse interpolate";
constexpr const char* kSurroundingsToo = "--environment studio, a colour or a panorama";

constexpr std::array kEffects{
    Effect{"asset-root", is_file, "on a built-in scene", "a scene file"},
    Effect{"texture-memory", is_file, "on a built-in scene", "a scene file"},
    Effect{"points", is_file, "on a built-in scene", "a PLY file of points"},
    Effect{"up", is_file, "on a built-in scene", "a scene file"},
    Effect{"crosstalk", precompensates, "without --precompensate", "--precompensate"},
    Effect{"packing", has_microlenses, "on optics without microlenses", "--optics microlens or plenoptic"},
    Effect{"fit-depth", has_parallax, "on a single view", "optics with several views"},
    Effect{"view-angle", has_parallax, "on a single view", "optics with several views"},
    Effect{"clamp-indirect", traces_paths, "without path tracing", "--integrator path"},
    Effect{"denoise", may_denoise, "without path tracing", "--integrator path"},
    Effect{"seed", has_random_numbers, "on a render without random numbers", "--spp 2 or more, or --integrator path"},
    Effect{"environment-strength", has_surroundings, "on a scene without surroundings", kSurroundingsToo},
    Effect{"environment-rotation", has_surroundings_to_turn, "on surroundings of one colour, or on none",
           "--environment studio or a panorama"},
    Effect{"exposure", makes_codes, "on EXR files, which stay linear", "--format png, png16 or tiff, or --video"},
    Effect{"tone", makes_codes, "on EXR files, which stay linear", "--format png, png16 or tiff, or --video"},
    Effect{"keyframes", has_key_frames, "where every frame is traced", "--reuse copy or interpolate"},
    Effect{"splat", interpolates, kNotInterpolated, kInterpolateToo},
    Effect{"fill", interpolates, kNotInterpolated, kInterpolateToo},
    Effect{"halving", interpolates, kNotInterpolated, kInterpolateToo},
    Effect{"no-z-buffer", interpolates, kNotInterpolated, kInterpolateToo},
    Effect{"stereo", wants_stereo, "on pictures other than stereo", "--layout stereo"},
    Effect{"right-first", wants_stereo, "on pictures other than stereo", "--layout stereo"},
    Effect{"binary", writes_colmap, "on formats other than colmap", "--to colmap"},
    Effect{"exr-pixels", makes_exr, "on pictures other than EXR", "--format exr"},
    Effect{"video-codec", makes_videos, "without a video", "--video FILE"},
    Effect{"crf", makes_lossy_videos, "without a video in a lossy format", "--video FILE that ends in .mp4, .mov or .webm"},
};

/// Returns the flags that set a parameter, such as "--packing" or "--fit-depth or --full-depth".
std::string flags_of(std::string_view parameter) {
  const std::string_view opposite = find_param(parameter)->opposite;
  return flag_of(parameter) + (opposite.empty() ? "" : " or " + flag_of(opposite));
}

}  // namespace

void refuse_idle_flags(std::span<const std::string_view> given, const ResolvedJob& job) {
  for (const Effect& effect : kEffects)
    if (std::find(given.begin(), given.end(), effect.parameter) != given.end() && !effect.exists(job.params()))
      throw usage_error(flags_of(effect.parameter), fmt::format("has no effect {}", effect.ineffective), effect.accepted);
}

}  // namespace lippmann
