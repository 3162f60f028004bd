#include "job/panel_size.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "lippmann/core/error.hpp"

namespace lippmann {

PanelSize panel_size(const RenderParams& params, Vec2i scene_resolution) {
  const OpticsKind kind = optics_kind(params);
  check_kind_params(params.optics, kind);
  const PanelSize size = kind.info().panel_size(params.optics, scene_resolution);
  const std::int64_t pixels = std::int64_t{size.width} * size.height;
  if (pixels > kMaxPixels || std::max(size.width, size.height) > kMaxSide)
    throw usage_error("--size, --lenses, --lens-pixels",
                      fmt::format("make a picture of {}x{} = {} pixels", size.width, size.height, pixels),
                      fmt::format("1 to {} pixels, at most {} a side", kMaxPixels, kMaxSide));
  return size;
}

}  // namespace lippmann
