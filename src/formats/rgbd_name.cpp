#include "formats/rgbd_name.hpp"

#include <string>

#include "core/text_pattern.hpp"
#include "layout/copy_mark.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::optional<PatternMatch> rgbd_name(const fs::path& path) {
  static const TextPattern name("(?:(.*)[_. -])?(h?)rgbd(" + std::string(kCopyMark) + ")?", TextPattern::Letters::kEitherCase);
  return name.match(path.stem().string());
}

}  // namespace

bool has_rgbd_name(const fs::path& path) { return rgbd_name(path).has_value(); }

bool has_half_rgbd_name(const fs::path& path) {
  const std::optional<PatternMatch> found = rgbd_name(path);
  return found && !found->groups[2].empty();
}

fs::path without_rgbd_name(const fs::path& path) {
  const std::optional<PatternMatch> found = rgbd_name(path);
  if (!found) return path;
  const std::string stem = found->groups[1].empty() ? "picture" : found->groups[1];
  return path.parent_path() / (stem + found->groups[3] + path.extension().string());
}

fs::path with_rgbd_name(const fs::path& named) {
  if (has_rgbd_name(named) && !has_half_rgbd_name(named)) return named;
  const fs::path path = without_rgbd_name(named);
  return path.parent_path() / (path.stem().string() + std::string(kRgbdEnding) + path.extension().string());
}

}  // namespace lippmann
