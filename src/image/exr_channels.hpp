// Finds the colour channels of an OpenEXR file by name. Private to src/image.
//
// A channel named "a.b.R" is channel R of layer "a.b"; ':' and '/' separate names too. "r", "Red" and "red" also mean R, and so
// on for G, B and A. Y, RY and BY of a luma-chroma image must be written exactly so. The colours are the first of these that
// exist:
// 1. channels without a layer: R, G and B; or Y, RY and BY; or Y alone (grey)
// 2. the colours of a layer named Combined, beauty, rgba or similar
// 3. the colours of the first layer that has colours; in a stereo image, the default view counts as the first layer
// 4. the only channel of a file (grey), unless its name means other data, such as alpha or depth
#pragma once

#include <span>
#include <string>
#include <vector>

namespace lippmann {

struct ExrColors {
  std::vector<std::string> channels;  ///< names of R, G, B, or of grey, or of Y, RY, BY; empty if the file has no colours
  std::string alpha;
  bool luma_chroma = false;
  /// False if the only channel of a file is taken as grey although its name does not mean grey.
  bool by_name = true;
  std::vector<std::string> others;  ///< other layers with colours, if the first such layer was taken
};

/// `names` must be in the file's order.
ExrColors find_exr_colors(std::span<const std::string> names);

/// Returns the colours, their alpha, then the other channels by layer. R, G, B, A and Z come first in each layer.
std::vector<std::string> sorted_exr_channels(std::span<const std::string> names, const ExrColors& colors);

}  // namespace lippmann
