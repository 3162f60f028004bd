#include "lippmann/formats/quilt_name.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "core/text_pattern.hpp"
#include "layout/copy_mark.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

const TextPattern& pattern() {
  static const TextPattern quilt(
      "(^|[_ .-])qs([0-9]{1,4})x([0-9]{1,4})a([0-9]*\\.?[0-9]+)(?:z[0-9.]*[0-9])?(?:f-?[0-9.]*[0-9])?"
      "(?:\\.(?:png|jpe?g|webp|exr|tiff?|bmp|ppm|mp4|webm))?(?=" +
          std::string(kCopyMark) + "?$)",
      TextPattern::Letters::kEitherCase);
  return quilt;
}

template <class Number>
Number read(const std::string& digits) {
  Number value{};
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

}  // namespace

QuiltName quilt_name_of(const DisplayQuilt& quilt) { return {{quilt.columns, quilt.rows}, quilt.aspect}; }

std::optional<QuiltName> parse_quilt_name(const std::filesystem::path& path) {
  constexpr double kLeastAspect = 0.1, kMostAspect = 10.0;  // limits of the aspect ratio if no underscore precedes "qs"
  const std::optional<PatternMatch> found = pattern().search(path.stem().string());
  if (!found) return std::nullopt;
  const auto& group = found->groups;
  const QuiltName name{{read<int>(group[2]), read<int>(group[3])}, read<double>(group[4])};
  if (group[1] != "_" && !(name.aspect >= kLeastAspect && name.aspect <= kMostAspect)) return std::nullopt;
  if (name.tiles.columns < 1 || name.tiles.rows < 1 || !(name.aspect > 0.0))
    throw Error(path.string(), "cannot parse the quilt file name: no tiles or no aspect", "a name such as room_qs8x6a0.75.png");
  return name;
}

std::optional<ViewGrid> tiles_in_name(const std::filesystem::path& path) {
  static const TextPattern tiles("qs([0-9]{1,4})x([0-9]{1,4})", TextPattern::Letters::kEitherCase);
  const std::optional<PatternMatch> found = tiles.search(path.stem().string());
  if (!found) return std::nullopt;
  const ViewGrid grid{read<int>(found->groups[1]), read<int>(found->groups[2])};
  return grid.columns > 0 && grid.rows > 0 ? std::optional(grid) : std::nullopt;
}

std::string quilt_ending(const QuiltName& quilt) {
  return fmt::format("_qs{}x{}a{:.6g}", quilt.tiles.columns, quilt.tiles.rows, quilt.aspect);
}

std::filesystem::path without_quilt_name(const std::filesystem::path& path) {
  std::string bare = path.stem().string();
  const auto found = pattern().search(bare);
  if (!found) return path;
  bare.erase(found->begin, found->end - found->begin);
  if (found->begin == 0) bare.insert(0, "quilt");
  return path.parent_path() / (bare + path.extension().string());
}

std::filesystem::path with_quilt_name(const std::filesystem::path& path, const QuiltName& quilt) {
  const std::filesystem::path bare = without_quilt_name(path);
  return bare.parent_path() / (bare.stem().string() + quilt_ending(quilt) + bare.extension().string());
}

}  // namespace lippmann
