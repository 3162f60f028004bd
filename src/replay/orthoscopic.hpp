// `lippmann convert --rotate-elemental` and `--spoc`: rendered or recorded pictures whose depth is the wrong way round, turned.
//
// Both move pixels and change none: 8- and 16-bit codes stay codes.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "replay/spoc.hpp"

namespace lippmann {

struct OrthoscopicParams {
  std::filesystem::path in;   ///< a picture, or a folder of frames, beside its report.json (replay/rendered_frames.hpp)
  std::filesystem::path out;  ///< a folder: pictures of the same names, and a report.json that says their optics
  std::optional<SpocParams> spoc = {};  ///< none: elemental images are rotated
  // The display's array; none: as the recorded one's.
  std::optional<double> lens_pitch_mm = {}, gap_mm = {};
  std::optional<int> lens_pixels = {};
};

/// Returns what was written, report.json last. Throws Error naming the flag or file; an `out` that is the folder of `in` is
/// refused. Stops between frames when context.cancelled is set.
std::vector<std::filesystem::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context);

}  // namespace lippmann
