// Makes optics of the kinds that flags can select from user parameters. Every model whose header declares kind_info()
// (optics/model.hpp) is such a kind; flags, job files, --help and messages use its OpticsKindInfo.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"
#include "optics/optics_params.hpp"

namespace lippmann {

/// The panel size from the parameters.
struct PanelSize {
  int width = 512, height = 512;  ///< pixels
  float lens_pixels = 0.0f;       ///< across a lens, along a pixel row; 0: no lenses
  Extent<int> views{1, 1};        ///< columns and rows of views side by side
};

/// The inputs for making a model.
struct ModelSetup {
  const OpticsParams& params;
  Panel panel;
  PanelSize size;
  float viewing_distance_mm;  ///< finite for optics without lenses
  Vec2f pixel_offset{0.0f};   ///< of the scene's camera
};

struct OpticsKindInfo {
  std::string_view name;                       ///< equals kind_of() the model
  std::string_view help = {};                  ///< follows the name in --help; may be empty
  std::array<std::string_view, 4> takes = {};  ///< the elements of kKindParams that have an effect
  bool has_parallax = true;                    ///< the picture changes as the eye moves

  /// Returns the panel size. `scene_resolution`: requested by the scene's file; {0, 0}: none. Throws a usage Error for
  /// contradictory parameters.
  PanelSize (*panel_size)(const OpticsParams& params, Vec2i scene_resolution);
  OpticsModel (*make_model)(const ModelSetup& setup);

  bool takes_param(std::string_view param) const;
};

extern const OpticsKindInfo lenticular_kind, microlens_kind, multiview_kind, single_kind;

/// Returns all kinds that flags can select, in the order of OpticsModel.
std::span<const OpticsKind> optics_kinds();

/// Throws a usage Error for parameters without effect on this kind.
void check_kind_params(const OpticsParams& params, OpticsKind kind);

/// Returns the help text of all kinds: "NAME (HELP), NAME or NAME".
std::string_view optics_kinds_help();

}  // namespace lippmann
