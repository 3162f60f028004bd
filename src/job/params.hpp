// The parameters of a render as the user gave them, in one plain struct. One table, params_table.hpp, reads and writes them as
// command-line flags and job-file keys. ResolvedJob (resolved_job.hpp) fills in the defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/frame_ranges.hpp"
#include "folder/picture_params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/math.hpp"
#include "lippmann/frames/frame_params.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/stage/choose_camera.hpp"
#include "lippmann/stage/view_wish.hpp"
#include "optics/optics_params.hpp"
#include "stage/camera_set.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

enum class ReuseChoice { kAuto, kNone, kCopy, kInterpolate };
enum class DebugPicture { kNone, kMissed };

/// The scene, its light, and the part of it to show.
struct SceneParams {
  std::string name;           ///< a built-in name or a file
  std::string camera_path;    ///< a Tachyon .cam file for a .dat scene; empty: none
  std::string animation;      ///< name or index of the animation to show; empty: the first
  std::string variant;        ///< name or index of the material variant; empty: the file's default
  std::string asset_root;     ///< folder that must contain the files the scene refers to; empty: the scene's own folder
  int texture_memory = 1024;  ///< MB for the decoded textures of a file; larger ones are halved until they fit
  std::string camera;         ///< name or index of the camera that sets the view; empty: the file's first camera
  UpAxis up = UpAxis::kY;     ///< the axis of the scene's file that points upwards
  double fps = 0.0;           ///< frames per second of the animation and of videos; 0: the scene's own
  float light_scale = 1.0f;   ///< factor for the lamps of the file
  /// "none", "studio", a colour or a panorama file; empty: chosen by light_scene() (job/scene_light.hpp).
  std::string environment;
  float environment_strength = 1.0f;      ///< factor for the light of the environment
  float environment_rotation_deg = 0.0f;  ///< rotation of the environment about the vertical
  /// Cameras around the scene, one per frame, that replace the scene's own; nullopt: the scene's own.
  std::optional<CameraSet> cameras{};
  /// Diameter of the points of a point cloud, in units of the file; nullopt: derived from their spacing.
  std::optional<double> point_size{};
  ViewWish view;
};

/// Reuse between frames, as given. Parameters without effect on the chosen kind of reuse must not be given
/// (job/reuse_params.hpp).
struct ReuseParams {
  ReuseChoice choice = ReuseChoice::kAuto;
  std::optional<int> keyframes{};       ///< frames per key frame; nullopt: chosen automatically, or kDefaultKeyframes
  std::optional<double> min_psnr_db{};  ///< minimum PSNR of every frame, computed on 8-bit codes
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;  ///< kInterpolate or kRetrace
  bool halving = false;
  bool no_z_buffer = false;
  DebugPicture debug = DebugPicture::kNone;  ///< kMissed leaves missed pixels black
};

/// Companions rendered from the same frames.
enum class Companion { kSingle };  ///< kSingle: the plain picture beside a light field (job/single_clip.hpp)

/// The frames to write, their destination and format.
struct OutputParams {
  std::string folder;                 ///< output folder; empty: out/<scene name>
  std::optional<FrameRanges> frames;  ///< frames to render; nullopt: the whole animation
  PictureParams pictures;
  std::vector<std::string> video;         ///< files; the extension selects the container
  std::optional<VideoCodec> video_codec;  ///< for all videos; nullopt: chosen by extension and size
  std::optional<int> crf;                 ///< for all lossy videos; nullopt: the codec's default
  std::optional<Companion> also;          ///< companion to render after the frames, into a subfolder
  bool page = false;                      ///< whether to write a page that shows the light field, after all frames
};

/// All parameters of a job, and how it is run.
struct RenderParams {
  Sampling sampling;
  ReuseParams reuse;
  SceneParams scene;
  OpticsParams optics;
  OutputParams output;
  int strips = 1;       ///< strips of rows per frame (frames/strip_maker.hpp); 1: whole frames
  int threads = 0;      ///< number of rendering threads; 0: one per processor
  bool resume = false;  ///< whether to keep frames finished by earlier runs of the same job
};

/// Returns whether the job's pictures hold two views, one per eye (job/screen_for_stereo.hpp).
bool wants_stereo(const RenderParams& params);

/// Returns the kind of optics: the given one, or lenticular by default.
inline OpticsKind optics_kind(const RenderParams& params) { return params.optics.kind.value_or(OpticsKind::kLenticular); }

/// Returns whether `scene` names a built-in scene, not a file.
bool is_builtin_scene(const std::string& scene);

/// Returns the output folder: `output`, or by default out/<scene name>. The scene name is that of the built-in scene, or the
/// file's name without folder and extension.
std::string output_folder(const RenderParams& params);

/// Returns the frames of the job, ascending. Throws a usage Error for frames outside the animation.
std::vector<int> frames_of_job(const RenderParams& params, const Timeline& timeline);

}  // namespace lippmann
