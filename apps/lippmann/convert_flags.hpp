// The flags of `lippmann convert`, and the conversions on which each flag has an effect.
#pragma once

#include <string>

#include "apps/lippmann/camera_flags.hpp"
#include "apps/lippmann/crosstalk_flags.hpp"
#include "apps/lippmann/depth_flags.hpp"
#include "apps/lippmann/display_picture_flags.hpp"
#include "apps/lippmann/orthoscopic_flags.hpp"
#include "apps/lippmann/plenoptic_flags.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "apps/lippmann/sheet_flags.hpp"
#include "apps/lippmann/stereo_flags.hpp"
#include "apps/lippmann/view_filter_flags.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann::app {

struct ConvertOptions {
  std::string in, out, from, to, views, quilt, crop, keep, display;
  double aspect = 0.0;
  ViewFilterFlags filter;
  int bits = 0;
  bool png = false, binary = false;
  ResultFlags result;
  OrthoscopicFlags orthoscopic;
  CrosstalkFlags crosstalk;
  StereoFlags stereo;
  DepthFlags depth;
  CameraFlags cameras;
  SheetFlags sheet;
  DisplayPictureFlags picture;
  PlenopticFlags plenoptic;

  bool has_display() const { return !display.empty() || sheet.are_given(); }
  /// Requires has_display(). Throws a usage Error naming an invalid flag.
  Display read_display() const;
};

enum class ConvertKind {
  kRearrange,   ///< moves the pixels of views
  kDisplay,     ///< resamples views for a display
  kDepthViews,  ///< computes views from RGB-D pictures
  kStereo,      ///< computes the views of two eyes
  kRotate,
  kSpoc,
  kPrecompensate,
};

struct Conversion {
  ConvertKind kind = ConvertKind::kRearrange;
  /// Formats to read and to write. Null for kRotate, kSpoc and kPrecompensate.
  const LightFieldFormat *from = nullptr, *to = nullptr;
  bool is_from_video = false;
};

/// Returns the requested conversion. Throws a usage Error for a missing --to, conflicting flags or an unknown format.
Conversion conversion_of(const ConvertOptions& options);

/// Throws a usage Error for a flag that has no effect on this conversion.
void refuse_idle_flags(const ConvertOptions& options, const Conversion& conversion);

}  // namespace lippmann::app
