// The layout and file format of each frame's picture.
#pragma once

#include <optional>
#include <string>

#include "core/extent.hpp"
#include "image/tone.hpp"
#include "lippmann/layout/depth_coding.hpp"
#include "lippmann/layout/stereo.hpp"

namespace lippmann {

/// Arrangement of the views' pixels (layout/view_layout.hpp).
enum class PictureLayout { kIntegral, kQuilt, kViews, kNative, kPrint, kStereo, kRgbd };
enum class PictureFormat { kPng, kPng16, kTiff, kExr };
enum class ExrPixels { kHalf, kFloat };

/// The coding of depth in RGB-D pictures (kRgbd).
struct DepthParams {
  std::optional<DepthRange> range;   ///< nullopt: the visible range over the animation (job/rgbd_options.hpp)
  std::optional<DepthScale> linear;  ///< quantity in which grey is linear; nullopt: disparity
  bool near_black = false;
};

struct PictureParams {
  float exposure_ev = 0.0f;             ///< for encoded pictures and videos; EXR stores linear light unchanged
  ToneCurve tone = ToneCurve::kNone;    ///< for encoded pictures and videos
  std::optional<PictureLayout> layout;  ///< nullopt: the native layout of the optics
  std::string to;                       ///< light-field format in place of a layout; empty: none
  bool pseudoscopic = false;            ///< kIntegral: rotate elemental images by 180 degrees, which inverts depth
  bool mirror = false;                  ///< kPrint: exchange left and right, for print on the back of a sheet
  Extent<int> quilt;                    ///< tiles of kQuilt; 0: native, or nearly square
  StereoLayout stereo;                  ///< for kStereo
  DepthParams depth;                    ///< for kRgbd
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
};

inline Tone tone_of(const PictureParams& pictures) { return {pictures.exposure_ev, pictures.tone}; }

}  // namespace lippmann
