#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"
#include "optics/optics_params.hpp"

namespace lippmann {

struct PanelSize {
  int width = 512, height = 512;
  float lens_pixels = 0.0f;  ///< number of pixels across a lens, along a pixel row; 0: no lenses
  Extent<int> views{1, 1};
};

struct ModelSetup {
  const OpticsParams& params;
  Panel panel;
  PanelSize size;
  float viewing_distance_mm;  ///< distance of the viewer or camera from the plane z = 0; infinite only for optics with lenses
  Vec2f pixel_offset{0.0f};
  /// Distance from the panel to a pinhole with the field of view of the scene's camera.
  float pinhole_mm = kInfinity;
  float f_number = 0.0f;  ///< f-number of a camera; 0: not given
};

struct OpticsKindInfo {
  std::string_view name;
  std::string_view help = {};
  std::array<std::string_view, 7> takes = {};  ///< names of the parameters of kKindParams that affect this kind
  bool has_parallax = true;
  bool is_camera = false;  ///< whether the panel is a camera's sensor, with the main lens at the scene's camera

  /// Returns the panel size. `scene_resolution` is the size that the scene's file requests, or {0, 0}. Throws a usage Error for
  /// contradictory parameters.
  PanelSize (*panel_size)(const OpticsParams& params, Vec2i scene_resolution);
  OpticsModel (*make_model)(const ModelSetup& setup);

  bool takes_param(std::string_view param) const;
};

extern const OpticsKindInfo lenticular_kind, microlens_kind, multiview_kind, single_kind, plenoptic_kind;

std::span<const OpticsKind> optics_kinds();

/// Throws a usage Error for parameters that have no effect on this kind.
void check_kind_params(const OpticsParams& params, OpticsKind kind);

std::string_view optics_kinds_help();

}  // namespace lippmann
