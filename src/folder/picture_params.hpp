// The layout and file format of each frame's picture.
#pragma once

#include <optional>
#include <string>

#include "core/extent.hpp"
#include "lippmann/formats/depth_coding.hpp"
#include "lippmann/image/tone.hpp"
#include "lippmann/layout/stereo.hpp"

namespace lippmann {

/// Arrangement of the views' pixels (layout/view_layout.hpp).
enum class PictureLayout { kIntegral, kQuilt, kViews, kNative, kPrint, kStereo, kRgbd };
enum class PictureFormat { kPng, kPng16, kTiff, kExr };
enum class ExrPixels { kHalf, kFloat };

/// The coding of depth in RGB-D pictures (kRgbd).
struct DepthParams {
  /// Coded depth range; nullopt: the range that is visible in the animation (job/rgbd_options.hpp).
  std::optional<DepthRange> range;
  /// Quantity that grey levels are linear in; nullopt: disparity.
  std::optional<DepthScale> linear;
  bool near_black = false;
};

struct PictureParams {
  /// Exposure in stops. EXR files store linear light without it.
  float exposure_ev = 0.0f;
  ToneCurve tone = ToneCurve::kNone;    ///< tone curve of encoded pictures and videos
  std::optional<PictureLayout> layout;  ///< nullopt: the native layout of the optics
  /// Light-field format that replaces the layout; may be empty.
  std::string to;
  bool binary = false;  ///< only for `to` colmap: writes binary files instead of text
  /// Only for kIntegral: rotates elemental images by 180 degrees, which inverts depth.
  bool pseudoscopic = false;
  /// Only for kPrint: exchanges left and right, for a print on the back of a sheet.
  bool mirror = false;
  /// Number of tiles of kQuilt; 0: the tiles of a native quilt, otherwise the grid of views, or a nearly square arrangement for
  /// a single row of views.
  Extent<int> quilt;
  StereoLayout stereo;  ///< only used by kStereo
  DepthParams depth;    ///< only used by kRgbd
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
};

inline Tone tone_of(const PictureParams& pictures) { return {pictures.exposure_ev, pictures.tone}; }

}  // namespace lippmann
