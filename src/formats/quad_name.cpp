#include "formats/quad_name.hpp"

#include <string>

#include "core/text_pattern.hpp"
#include "layout/copy_mark.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::optional<PatternMatch> quad_name(const fs::path& path) {
  static const TextPattern name("(.+)_2x2(" + std::string(kCopyMark) + ")?", TextPattern::Letters::kEitherCase);
  return name.match(path.stem().string());
}

}  // namespace

bool has_quad_name(const fs::path& path) { return quad_name(path).has_value(); }

fs::path without_quad_name(const fs::path& path) {
  const std::optional<PatternMatch> found = quad_name(path);
  if (!found) return path;
  return path.parent_path() / (found->groups[1] + found->groups[2] + path.extension().string());
}

fs::path with_quad_name(const fs::path& path) {
  if (has_quad_name(path)) return path;
  return path.parent_path() / (path.stem().string() + std::string(kQuadEnding) + path.extension().string());
}

}  // namespace lippmann
