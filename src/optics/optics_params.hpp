// The parameters from which optics are made where no display says what they are. Flags and keys of job files are read into
// them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct OpticsKindInfo;  // optics/optics_kind.hpp

/// A kind of optics that a flag can name. Its value refers to what the model says of itself.
class OpticsKind {
 public:
  static const OpticsKind kLenticular, kMicrolens, kMultiview, kSingle;

  /// `info` must outlive the result.
  constexpr explicit OpticsKind(const OpticsKindInfo& info) : info_(&info) {}

  const OpticsKindInfo& info() const { return *info_; }

  friend bool operator==(OpticsKind, OpticsKind) = default;

 private:
  const OpticsKindInfo* info_;
};

/// How far the viewer's eyes are above the middle of the display, or below it.
struct EyeHeight {
  float value = 0.0f;     ///< mm, or degrees
  bool is_angle = false;  ///< seen from the middle of the display
};

struct OpticsParams {
  std::string display{};                       ///< a preset, a file of one's own or a calibration; empty: none
  std::optional<OpticsKind> kind{};            ///< none: the display's, or lenticular
  LensPacking packing = LensPacking::kSquare;  ///< microlens arrays
  Extent<int> lenses{};                        ///< 0: 64 across, and as many down as fill the panel
  Extent<float> lens_pixels{};                 ///< pixels below a lens, not necessarily whole; 0: 8
  Extent<int> size{};                          ///< the whole panel in pixels; 0: lenses x lens-pixels
  Extent<int> views{};                         ///< multi-view: columns and rows of the quilt; 0: 8x6
  bool camera_grid = false;                    ///< multi-view: eyes at equal distances across and up, not at equal angles
  bool cone_ends = false;                      ///< multi-view: the outermost eyes stand at the ends of the viewing zone
  std::optional<float> view_angle_deg{};       ///< viewing zone, full angle; sets the gap; none: the display's, or 28
  std::optional<float> viewing_distance_mm{};  ///< none: where the scene's camera stands; inf: parallel cells
  std::optional<EyeHeight> eye_height{};       ///< none: at the height of the display's middle
  std::optional<bool> fit_depth{};             ///< depth is compressed to what the display can resolve; see fits_depth()
  float slant_deg = 0.0f;                      ///< how far a lenticular sheet's lenses lean from the vertical
  std::optional<double> ipd_mm{};              ///< stereo: between the eyes; none: kUsualIpdMm
  std::optional<double> screen_width_mm{};     ///< stereo: of the screen; none: the display's, or kUsualScreenMm
  std::optional<double> crosstalk_px{};        ///< sigma (optics/crosstalk.hpp); none: the display's
  bool precompensate = false;                  ///< pictures are such that crosstalk makes the wanted ones of them
};

/// A parameter that only some kinds of optics take (OpticsKindInfo::takes).
struct KindParam {
  std::string_view name;  ///< of its flag
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
};

/// Returns the viewing angle of the parameters, or 28 degrees, in radians.
float view_angle(const OpticsParams& params);

}  // namespace lippmann
