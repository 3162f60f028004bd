// Finds the colour channels of an OpenEXR file by name. Private to src/image.
//
// A channel called "a.b.R" is R of the layer "a.b"; '.', ':' and '/' separate. Letters count in either case, and words ("Red")
// as their first letter (but not of RY and BY, which OpenEXR reads). Colours are, where there is one of these, in this order:
//   R, G and B, Y with RY and BY, or Y (grey) without a layer; of the layer called Combined, beauty, rgba or similar; of the
//   first layer that has some; the only channel of a file (grey), unless its name is that of data such as alpha or depth.
// The default view of a stereo picture is its first layer.
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
