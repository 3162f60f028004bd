// Makes optics from user parameters, for the kinds that flags can select. Every model whose header declares kind_info()
// (optics/model.hpp) is such a kind. Flags, job files, --help and messages use its OpticsKindInfo.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"
#include "optics/optics_params.hpp"

namespace lippmann {

/// The size of a panel, as it follows from the parameters.
struct PanelSize {
  int width = 512, height = 512;  ///< size in pixels
  float lens_pixels = 0.0f;       ///< number of pixels across a lens, along a pixel row; 0: no lenses
  Extent<int> views{1, 1};        ///< number of columns and rows of views side by side
};

/// The inputs for making a model.
struct ModelSetup {
  const OpticsParams& params;
  Panel panel;
  PanelSize size;
  float viewing_distance_mm;  ///< finite for optics without lenses; of a camera: from it to the plane z = 0
  Vec2f pixel_offset{0.0f};   ///< pixel offset of the scene's camera
  /// Distance from the panel to a pinhole with the field of view of the scene's camera.
  float pinhole_mm = kInfinity;
  float f_number = 0.0f;  ///< 0: not given
};

struct OpticsKindInfo {
  std::string_view name;                       ///< the result of kind_of() for the model
  std::string_view help = {};                  ///< text that follows the name in --help; may be empty
  std::array<std::string_view, 7> takes = {};  ///< the elements of kKindParams that have an effect on this kind
  bool has_parallax = true;                    ///< the picture changes as the eye moves
  bool is_camera = false;  ///< the panel is a sensor `sensor_width_mm` wide, behind a lens at the scene's camera

  /// Returns the panel size. `scene_resolution`: the size that the scene's file requests; {0, 0}: none. Throws a usage Error
  /// for contradictory parameters.
  PanelSize (*panel_size)(const OpticsParams& params, Vec2i scene_resolution);
  OpticsModel (*make_model)(const ModelSetup& setup);

  bool takes_param(std::string_view param) const;
};

extern const OpticsKindInfo lenticular_kind, microlens_kind, multiview_kind, single_kind, plenoptic_kind;

/// Returns all kinds that flags can select, in the order of OpticsModel.
std::span<const OpticsKind> optics_kinds();

/// Throws a usage Error for parameters that have no effect on this kind.
void check_kind_params(const OpticsParams& params, OpticsKind kind);

/// Returns the help text of all kinds: "NAME (HELP), NAME or NAME".
std::string_view optics_kinds_help();

}  // namespace lippmann
