// What lies behind a lens array, and the plenoptic camera's variant of it, whose elements are not turned round.
#include "layout/packed_views.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ViewGrid wanted_views(const fs::path& path, const FormatOptions& options) {
  if (options.views) return *options.views;
  throw usage_error("views", "the number of pixels below each lens of " + path.string() + " is unknown", "CxR, such as 8x1");
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
  return {.name = "integral",
          .is = "what lies behind a lens array; `views`: pixels below each lens",
          .read = read_integral<LayoutKind::kIntegral>,
          .write = write_integral<LayoutKind::kIntegral>,
          .reads = {.views = true}};
}

LightFieldFormat eslf_format() {
  return {.name = "eslf",
          .is = "plenoptic camera: view (u, v) from the top left is every N-th pixel from (u, v); `views` 14x14 and the like",
          .read = read_integral<LayoutKind::kEslf>,
          .write = write_integral<LayoutKind::kEslf>,
          .reads = {.views = true}};
}

}  // namespace lippmann
