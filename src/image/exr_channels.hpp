// Finds the colour channels of an OpenEXR file by name. Private to src/image.
//
// A channel named "a.b.R" is channel R of layer "a.b"; the separators are '.', ':' and '/'. Case is ignored, and words ("Red")
// count as their first letter, except for RY and BY, which OpenEXR reads. The colours are the first of these that exist:
// 1. outside of layers: R, G and B; or Y with RY and BY; or Y (grey)
// 2. the colours of a layer named Combined, beauty, rgba or similar
// 3. the colours of the first layer that has colours
// 4. the only channel of a file (grey), unless it is named like data such as alpha or depth
// The default view of a stereo image counts as its first layer.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct ExrColors {
  std::vector<std::string> channels;  ///< names of R, G, B; or grey; or Y, RY, BY; empty: the file has no colours
  std::string alpha;                  ///< name of the same layer's alpha; empty: it has none
  bool luma_chroma = false;           ///< channels are Y, RY and BY
  /// False: the file has a single channel, which is taken as grey although its name does not identify it.
  bool by_name = true;
  std::vector<std::string> others;  ///< other layers with colours, if the layer was chosen only because it comes first
};

/// Finds the colours. `names` must be in the file's order.
ExrColors find_exr_colors(std::span<const std::string> names);

/// Returns all names: the colours, their alpha, then the others by layer, where R, G, B, A, Z come first in each layer.
std::vector<std::string> sorted_exr_channels(std::span<const std::string> names, const ExrColors& colors);

}  // namespace lippmann
