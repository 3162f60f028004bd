// `lippmann convert --precompensate`: finished pictures made such that a display's crosstalk turns them into the wanted ones.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "layout/precompensate.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

struct PrecompensateParams {
  std::filesystem::path in;           ///< a picture, or a folder of frames, beside its report.json (replay/rendered_frames.hpp)
  std::filesystem::path out;          ///< a folder: pictures of the same names, and a report.json
  double sigma_px = 0.0;              ///< optics/crosstalk.hpp
  std::optional<Optics> optics = {};  ///< those that the pictures are for; none: as the report.json beside them says
};

struct Precompensated {
  std::vector<std::filesystem::path> written;  ///< report.json last
  Precompensation bound;                       ///< the mean share clipped, the largest residual of any
};

/// Codes become codes of as many bits. Throws Error naming the flag or file. Stops between frames when context.cancelled is
/// set.
Precompensated precompensate_frames(const PrecompensateParams& params, const Context& context);

}  // namespace lippmann
