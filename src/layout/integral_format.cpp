// What lies behind a lens array, and the plenoptic camera's variant of it, whose elements are not turned round.
#include "layout/packed_views.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ViewGrid wanted_views(const fs::path& path, const FormatOptions& options) {
  if (options.views) return *options.views;
  throw usage_error("views", path.string() + " does not say how many pixels lie below its lenses", "CxR, such as 8x1");
}

template <LayoutKind kind>
LightField read_integral(const fs::path& path, const FormatOptions& options) {
  return read_packed(path, {kind, wanted_views(path, options), {}}, options.with_depth, options.warn);
}

template <LayoutKind kind>
std::vector<fs::path> write_integral(const LightField& field, const fs::path& path, const FormatOptions&) {
  return write_packed(field, {kind, field.grid, {}}, path);
}

}  // namespace

LightFieldFormat integral_format() {
  return {"integral",
          "what lies behind a lens array; `views`: pixels below each lens",
          false,
          false,
          read_integral<LayoutKind::kIntegral>,
          write_integral<LayoutKind::kIntegral>};
}

LightFieldFormat eslf_format() {
  return {"eslf",
          "plenoptic camera: view (u, v) from the top left is every N-th pixel from (u, v); `views` 14x14 and the like",
          false,
          false,
          read_integral<LayoutKind::kEslf>,
          write_integral<LayoutKind::kEslf>};
}

}  // namespace lippmann
