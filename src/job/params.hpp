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

/// Which scene, in what light, and what of it is looked at.
struct SceneParams {
  std::string name;                   ///< a built-in name or a file
  std::string camera_path;            ///< a Tachyon .cam file for a .dat scene; empty: none
  std::string animation;              ///< name or index of the one to show, of scenes that hold several; empty: the first
  std::string variant;                ///< name or index of the set of materials, of scenes that hold several; empty: the file's
  std::string asset_root;             ///< files that the scene names may lie below it; empty: in its own folder only
  int texture_memory = 1024;          ///< MB for the decoded textures of a file; larger ones are halved until they fit
  std::string camera;                 ///< name or index of the one that decides the view; empty: the first
  UpAxis up = UpAxis::kY;             ///< the axis of the scene's file that points upwards
  double fps = 0.0;                   ///< frames per second of the animation and of videos; 0: the scene's own
  float light_scale = 1.0f;           ///< factor on the light of the file's lamps
  std::string environment;            ///< none, studio, a colour or a panorama; empty: see job/scene_light.hpp
  float environment_strength = 1.0f;  ///< factor
  float environment_rotation_deg = 0.0f;  ///< about the vertical
  std::optional<CameraSet> cameras{};     ///< around the scene, one for each frame, instead of its own; none: its own
  std::optional<double> point_size{};     ///< diameter of points, in units of their file; none: chosen from their spacing
  ViewWish view;
};

/// What frames take from each other, as requested: parameters of other kinds must not be given (job/reuse_params.hpp).
struct ReuseParams {
  ReuseChoice choice = ReuseChoice::kAuto;
  std::optional<int> keyframes{};       ///< a key frame every K frames; none: chosen, or kDefaultKeyframes
  std::optional<double> min_psnr_db{};  ///< what every frame's PSNR is to reach, in 8-bit codes
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;  ///< kInterpolate or kRetrace
  bool halving = false;
  bool no_z_buffer = false;
  DebugPicture debug = DebugPicture::kNone;  ///< kMissed: missed pixels stay black
};

/// Companions rendered from the same frames.
enum class Companion { kSingle };  ///< kSingle: the plain picture beside a light field (job/single_clip.hpp)

/// Which frames are written, where to, and as what.
struct OutputParams {
  std::string folder;                 ///< empty: out/<scene name>
  std::optional<FrameRanges> frames;  ///< none: the whole animation
  PictureParams pictures;
  std::vector<std::string> video;         ///< files; the ending says which kind
  std::optional<VideoCodec> video_codec;  ///< for all videos; none: by ending and size
  std::optional<int> crf;                 ///< for all videos that lose anything; none: the codec's own
  std::optional<Companion> also;          ///< rendered when the frames are done, into a folder in theirs
  bool page = false;                      ///< a page that shows the light field is written when all frames are done
};

/// All of it, and how it is run.
struct RenderParams {
  Sampling sampling;
  ReuseParams reuse;
  SceneParams scene;
  OpticsParams optics;
  OutputParams output;
  int strips = 1;       ///< of rows that each frame is rendered in (frames/strip_maker.hpp); 1: whole
  int threads = 0;      ///< 0: one per processor
  bool resume = false;  ///< keep the frames that the same job has finished before
};

/// Whether pictures are to hold the views of two eyes (job/screen_for_stereo.hpp).
bool wants_stereo(const RenderParams& params);

/// What is traced: as given, or lenticular.
inline OpticsKind optics_kind(const RenderParams& params) { return params.optics.kind.value_or(OpticsKind::kLenticular); }

/// Whether `scene` names one of the built-in scenes, and thus no file.
bool is_builtin_scene(const std::string& scene);

/// `output`, or by default out/<scene name>: the built-in's name, or the file's without folder and ending.
std::string output_folder(const RenderParams& params);

/// The frames that the job asks for, ascending. Throws a usage Error for those outside the animation.
std::vector<int> frames_of_job(const RenderParams& params, const Timeline& timeline);

}  // namespace lippmann
