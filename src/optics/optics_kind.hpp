// How parameters make the optics of each kind that a flag can name. A model whose header has kind_info() (optics/model.hpp) is
// such a kind: flags, job files, --help and refusals follow from what it returns.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/extent.hpp"
#include "lippmann/optics/optics.hpp"
#include "optics/optics_params.hpp"

namespace lippmann {

/// The panel that parameters ask for.
struct PanelSize {
  int width = 512, height = 512;  ///< pixels
  float lens_pixels = 0.0f;       ///< across a lens, along a pixel row; 0: there are no lenses
  Extent<int> views{1, 1};        ///< columns and rows of views side by side
};

/// The values from which a model is made.
struct ModelSetup {
  const OpticsParams& params;
  Panel panel;
  PanelSize size;
  float viewing_distance_mm;  ///< finite where there are no lenses
  Vec2f pixel_offset{0.0f};   ///< of the scene's camera
};

struct OpticsKindInfo {
  std::string_view name;                       ///< kind_of() the model
  std::string_view help = {};                  ///< stands behind the name in --help; may be empty
  std::array<std::string_view, 4> takes = {};  ///< those of kKindParams that have an effect
  bool has_parallax = true;                    ///< an eye that moves sees another picture

  /// Returns the panel. `scene_resolution`: the size that the scene's file asks for; {0, 0}: none. Throws a usage Error for
  /// parameters that contradict each other.
  PanelSize (*panel_size)(const OpticsParams& params, Vec2i scene_resolution);
  OpticsModel (*make_model)(const ModelSetup& setup);

  bool takes_param(std::string_view param) const;
};

extern const OpticsKindInfo lenticular_kind, microlens_kind, multiview_kind, single_kind;

/// Returns all kinds that a flag can name, in the order of OpticsModel.
std::span<const OpticsKind> optics_kinds();

/// Throws a usage Error for a parameter that has no effect on this kind.
void refuse_params_of_other_kinds(const OpticsParams& params, OpticsKind kind);

/// Returns "NAME (HELP), NAME or NAME": all kinds.
std::string_view optics_kinds_help();

}  // namespace lippmann
