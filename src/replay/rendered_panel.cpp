#include "lippmann/replay/rendered_panel.hpp"

#include <fmt/format.h>

#include "image/require_samples.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {

void validate(const RenderedPanel& rendered) {
  constexpr const char* kField = "picture";
  validate(rendered.optics);
  require_samples(rendered.picture, kField);
  require_channels(rendered.picture, 3, kField);
  const Vec2i panel = picture_size(rendered.optics);
  if (rendered.picture.width != panel.x || rendered.picture.height != panel.y)
    throw Error(kField, fmt::format("has {}x{} pixels", rendered.picture.width, rendered.picture.height),
                fmt::format("{}x{}, the size of the panel", panel.x, panel.y));
}

}  // namespace lippmann
