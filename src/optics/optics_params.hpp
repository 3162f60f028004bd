#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct OpticsKindInfo;

class OpticsKind {
 public:
  static const OpticsKind kLenticular, kMicrolens, kMultiview, kSingle;

  constexpr explicit OpticsKind(const OpticsKindInfo& info) : info_(&info) {}

  const OpticsKindInfo& info() const { return *info_; }

  friend bool operator==(OpticsKind, OpticsKind) = default;

 private:
  const OpticsKindInfo* info_;
};

struct EyeHeight {
  float value = 0.0f;
  bool is_angle = false;  ///< whether the height is an angle as seen from the middle of the display
};

struct OpticsParams {
  std::string display{};             ///< name of a preset, a display file or a calibration; empty: no display
  std::optional<OpticsKind> kind{};  ///< no value: the kind of the display, or lenticular without a display
  LensPacking packing = LensPacking::kSquare;
  Extent<int> lenses{};         ///< number of lenses; 0: 64 across, and as many down as fit the panel
  Extent<float> lens_pixels{};  ///< number of pixels below a lens, may be fractional; 0: 8
  Extent<int> size{};           ///< size of the whole panel in pixels; 0: lenses x lens_pixels
  Extent<int> views{};          ///< multi-view: number of columns and rows of the quilt; 0: 8x6
  /// Multi-view. True: eyes are at equal distances across and up. False: eyes are at equal angles in one row.
  bool camera_grid = false;
  bool cone_ends = false;  ///< multi-view: the outermost eyes are at the ends of the viewing zone
  /// Full angle of the viewing zone, which determines the gap. No value: the angle of the display, or 28 degrees.
  std::optional<float> view_angle_deg{};
  /// No value: distance of the scene's camera; infinity: a view's rays are parallel.
  std::optional<float> viewing_distance_mm{};
  std::optional<EyeHeight> eye_height{};    ///< no value: the eyes are level with the middle of the display
  std::optional<bool> fit_depth{};          ///< whether to reduce depth to what the display resolves; see fits_depth()
  float slant_deg = 0.0f;                   ///< angle between the lenses of a lenticular sheet and the vertical
  std::optional<double> ipd_mm{};           ///< stereo: distance between the eyes; no value: kDefaultIpdMm
  std::optional<double> screen_width_mm{};  ///< stereo: width of the screen; no value: the display's or kDefaultScreenMm
  std::optional<double> crosstalk_px{};     ///< sigma of the lens blur (optics/crosstalk.hpp); no value: the display's
  bool precompensate = false;               ///< whether to change pictures to counteract the display's crosstalk
  /// Lengths of a plenoptic camera. Defaults: the sensor is kSensorWidthMm wide; the main lens has the field of view of the
  /// scene's camera; the images below the lenses touch; the microlenses are focused at infinity.
  std::optional<float> sensor_width_mm{}, focal_length_mm{}, gap_mm{}, lens_focal_length_mm{};
};

/// A parameter that applies only to some kinds of optics (OpticsKindInfo::takes).
struct KindParam {
  std::string_view name;  ///< name of the flag
  bool (*is_given)(const OpticsParams&);
};

inline constexpr std::array kKindParams{
    KindParam{"lenses", [](const OpticsParams& params) { return params.lenses.x > 0; }},
    KindParam{"lens-pixels", [](const OpticsParams& params) { return params.lens_pixels.x > 0.0f; }},
    KindParam{"packing", [](const OpticsParams& params) { return params.packing != LensPacking::kSquare; }},
    KindParam{"slant", [](const OpticsParams& params) { return params.slant_deg != 0.0f; }},
    KindParam{"views", [](const OpticsParams& params) { return params.views.x > 0; }},
    KindParam{"camera-grid", [](const OpticsParams& params) { return params.camera_grid; }},
    KindParam{"cone-ends", [](const OpticsParams& params) { return params.cone_ends; }},
    KindParam{"sensor-width", [](const OpticsParams& params) { return params.sensor_width_mm.has_value(); }},
    KindParam{"focal-length", [](const OpticsParams& params) { return params.focal_length_mm.has_value(); }},
    KindParam{"gap", [](const OpticsParams& params) { return params.gap_mm.has_value(); }},
    KindParam{"lens-focal-length", [](const OpticsParams& params) { return params.lens_focal_length_mm.has_value(); }},
};

float view_angle(const OpticsParams& params);

}  // namespace lippmann
