// The parameters of a render as the user gave them. params_table.hpp reads and writes them as flags and job-file keys.
// ResolvedJob fills in the defaults.
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
#include "lippmann/stage/camera_set.hpp"
#include "lippmann/stage/choose_camera.hpp"
#include "lippmann/stage/view_wish.hpp"
#include "optics/optics_params.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

enum class ReuseChoice { kAuto, kNone, kCopy, kInterpolate };
enum class DebugPicture { kNone, kMissed };

struct SceneParams {
  std::string name;  ///< built-in scene or file
  /// Tachyon .cam file for a .dat scene; may be empty.
  std::string camera_path;
  /// Name or index of the animation; empty: the first one.
  std::string animation;
  /// Name or index of the material variant; empty: the default of the file.
  std::string variant;
  /// Folder that must contain all files that the scene refers to; empty: the folder of the scene.
  std::string asset_root;
  /// Limit in MB for the decoded textures of a file. Larger textures are halved until they fit.
  int texture_memory = 1024;
  /// Name or index of the camera that sets the view; empty: the first camera of the file.
  std::string camera;
  UpAxis up = UpAxis::kY;  ///< axis of the scene's file that points upwards
  /// Frames per second of the animation and of videos; 0: the frame rate of the scene.
  double fps = 0.0;
  float light_scale = 1.0f;  ///< factor for the lamps of the file
  /// "none", "studio", a colour or a panorama file; empty: light_scene() chooses (job/scene_light.hpp).
  std::string environment;
  float environment_strength = 1.0f;  ///< factor for the light of the environment
  float environment_rotation_deg = 0.0f;
  /// Cameras around the scene, one per frame, which replace the scene's own cameras.
  std::optional<CameraSet> cameras{};
  /// Diameter of the points of a point cloud, in units of the file. If nullopt, it is derived from the spacing of the points.
  std::optional<double> point_size{};
  ViewWish view;
};

struct ReuseParams {
  ReuseChoice choice = ReuseChoice::kAuto;
  /// Frames from one key frame to the next; nullopt: kDefaultKeyframes for Interpolate without a minimum PSNR,
  /// otherwise chosen automatically.
  std::optional<int> keyframes{};
  std::optional<double> min_psnr_db{};  ///< minimum PSNR of every frame in dB, after rounding to 8 bits
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;  ///< only kInterpolate and kRetrace are allowed
  bool halving = false;
  bool no_z_buffer = false;
  DebugPicture debug = DebugPicture::kNone;  ///< kMissed leaves pixels black that no projected point covers
};

enum class Companion { kSingle };  ///< render of a single view beside a light field (job/single_clip.hpp)

struct OutputParams {
  std::string folder;                 ///< empty: out/<scene name>
  std::optional<FrameRanges> frames;  ///< nullopt: the whole animation
  PictureParams pictures;
  /// The extension of a video file selects the container.
  std::vector<std::string> video;
  /// Codec of all videos; nullopt: chosen by extension and size.
  std::optional<VideoCodec> video_codec;
  /// Quality (CRF) of all lossy videos; nullopt: the default of the codec.
  std::optional<int> crf;
  std::optional<Companion> also;  ///< additional render into a subfolder, made after the frames
  bool page = false;              ///< writes a web page that shows the light field, after all frames
};

struct RenderParams {
  Sampling sampling;
  ReuseParams reuse;
  SceneParams scene;
  OpticsParams optics;
  OutputParams output;
  /// Strips of rows per frame (frames/strip_maker.hpp); 1: whole frames.
  int strips = 1;
  /// Rendering threads; 0: one per processor.
  int threads = 0;
  bool resume = false;  ///< keeps frames that earlier runs of the same job have finished
};

/// Returns whether the pictures hold two views, one per eye (job/screen_for_stereo.hpp).
bool wants_stereo(const RenderParams& params);

inline OpticsKind optics_kind(const RenderParams& params) { return params.optics.kind.value_or(OpticsKind::kLenticular); }

bool is_builtin_scene(const std::string& scene);

/// Returns `output`, or out/<scene name> by default. The scene name is that of a built-in scene, or the file's name
/// without folder and extension.
std::string output_folder(const RenderParams& params);

/// Returns the frames in ascending order. Throws a usage Error for frames outside the animation.
std::vector<int> frames_of_job(const RenderParams& params, const Timeline& timeline);

}  // namespace lippmann
