// What the frames of an animation take from each other: one of several kinds of reuse, each with its own parameters.
#pragma once

#include <optional>
#include <variant>

#include "lippmann/reuse/projection_choices.hpp"

namespace lippmann {

/// ShareLight or CopySettled where the sampling allows it, else TraceAll: see resolved_reuse().
struct AutoReuse {};

/// Every frame is traced, and nothing is shared.
struct TraceAll {};

/// Whitted's shading: pixels that provably stay as they are are copied from key frames. The same bits as TraceAll.
struct CopySettled {
  std::optional<int> keyframes{};  ///< a key frame every so many frames; none: chosen where it pays
};

/// What an error is of.
enum class QualityAt {
  kPixel,  ///< single pixels of the film
  kEye,    ///< what an eye sees of them through the display's lenses, which mix neighbours (optics/crosstalk.hpp)
};

/// Paths: soft light is shared by pixels, views and frames; every frame's error is measured, and frames are as good as those of
/// all paths (Sampling::spp), or as is asked for here.
struct ShareLight {
  std::optional<double> min_psnr_db{};    ///< a floor for every frame, 8-bit codes, in place of spp
  std::optional<double> time_budget_s{};  ///< about what a frame takes on this machine, in place of spp; not with min_psnr_db
  bool show_provenance = false;           ///< pictures show where light came from instead of the light
  QualityAt quality_at = QualityAt::kPixel;  ///< what min_psnr_db, or the promise of spp, is for; kPixel with time_budget_s
  /// The display's, a sigma in the optics' pixels or views, 0 ... kMaxBlurPx (optics/crosstalk.hpp): with it, errors are told
  /// at the eye, too. 0: it is not known, or undone in the pictures, and an eye sees single pixels.
  double crosstalk_px = 0.0;
};

/// The paper's: frames between key frames are made from the points of these, and what no point lands on is filled. Whitted's
/// shading alone.
struct Interpolate {
  std::optional<int> keyframes{};       ///< a key frame every so many frames; none: kDefaultKeyframes, or chosen with a floor
  std::optional<double> min_psnr_db{};  ///< a floor for every frame, 8-bit codes: uncertain pixels are traced; none: no floor
  SplatMode splat = SplatMode::kView;
  MissedFill fill = MissedFill::kInterpolate;
  bool halving = false;      ///< made frames are sources too (reuse/frame_plan.hpp); else key frames only
  bool no_z_buffer = false;  ///< points overwrite each other in pixel order: wrong, for study
};

using Reuse = std::variant<AutoReuse, TraceAll, CopySettled, ShareLight, Interpolate>;

/// The default for interpolated animations.
inline constexpr int kDefaultKeyframes = 8;

/// auto, none, copy, light or interpolate.
const char* name_of(const Reuse& reuse);

}  // namespace lippmann
