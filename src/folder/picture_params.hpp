// What each frame's picture holds, and the kind of file that it goes into.
#pragma once

#include <optional>
#include <string>

#include "core/extent.hpp"
#include "image/tone.hpp"
#include "lippmann/layout/depth_coding.hpp"
#include "lippmann/layout/stereo.hpp"

namespace lippmann {

/// Where the pixels of views lie (layout/view_layout.hpp).
enum class PictureLayout { kIntegral, kQuilt, kViews, kNative, kPrint, kStereo, kRgbd };
enum class PictureFormat { kPng, kPng16, kTiff, kExr };
enum class ExrPixels { kHalf, kFloat };

/// How the grey of kRgbd means depth.
struct DepthParams {
  std::optional<DepthRange> range;   ///< none: what the scene shows over its animation (job/rgbd_options.hpp)
  std::optional<DepthScale> linear;  ///< what grey is linear in; none: disparity
  bool near_black = false;
};

struct PictureParams {
  float exposure_ev = 0.0f;             ///< for pictures in codes and for videos; EXR stays as the light is
  ToneCurve tone = ToneCurve::kNone;    ///< for the same
  std::optional<PictureLayout> layout;  ///< none: as the optics lie, lens by lens or tile by tile
  std::string to;                       ///< a format of light fields (layout/formats.hpp), in place of a layout; empty: none
  bool pseudoscopic = false;            ///< kIntegral: as a lens array records, depth turned round
  bool mirror = false;                  ///< kPrint: left and right exchanged, for print on the back of a sheet
  Extent<int> quilt;                    ///< tiles of kQuilt; 0: as the optics lie, or as square as can be
  StereoLayout stereo;                  ///< for kStereo
  DepthParams depth;                    ///< for kRgbd
  PictureFormat format = PictureFormat::kPng;
  ExrPixels exr_pixels = ExrPixels::kHalf;
};

inline Tone tone_of(const PictureParams& pictures) { return {pictures.exposure_ev, pictures.tone}; }

}  // namespace lippmann
