// Finds the colour channels of an OpenEXR file by name. Private to src/image.
//
// A channel named "a.b.R" is channel R of layer "a.b"; the separators are '.', ':' and '/'. Case is ignored, and words ("Red")
// count as their first letter, except for RY and BY, which OpenEXR reads. The colours are the first of these that exist: R, G
// and B, Y with RY and BY, or Y (grey) without a layer; those of a layer named Combined, beauty, rgba or similar; those of the
// first layer with colours; the only channel of a file (grey), unless its name is that of data such as alpha or depth. The
// default view of a stereo image is its first layer.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct ExrColors {
  std::vector<std::string> channels;  ///< R, G, B; or grey; or Y, RY, BY; empty: the file has no colours
  std::string alpha;                  ///< of the same layer; empty: none
  bool luma_chroma = false;           ///< channels are Y, RY and BY
  bool by_name = true;                ///< false: the only channel, taken as grey whatever its name
  std::vector<std::string> others;    ///< other layers with colours, if the choice is only by order
};

/// Finds the colours. names: in the file's order.
ExrColors find_exr_colors(std::span<const std::string> names);

/// Returns all names: colours, alpha, then the rest by layer, with R, G, B, A, Z first in each layer.
std::vector<std::string> sorted_exr_channels(std::span<const std::string> names, const ExrColors& colors);

}  // namespace lippmann
