#include "lippmann/layout/quilt_name.hpp"

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
      "_qs([0-9]{1,4})x([0-9]{1,4})a([0-9]*\\.?[0-9]+)(?:z[0-9.]+)?(?:f-?[0-9.]+)?(?=" + std::string(kCopyMark) + "?$)",
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
  const std::optional<PatternMatch> found = pattern().search(path.stem().string());
  if (!found) return std::nullopt;
  const auto& group = found->groups;
  const QuiltName name{{read<int>(group[1]), read<int>(group[2])}, read<double>(group[3])};
  if (name.tiles.columns < 1 || name.tiles.rows < 1 || !(name.aspect > 0.0))
    throw Error(path.string(), "cannot parse the quilt file name: no tiles or no aspect", "a name such as room_qs8x6a0.75.png");
  return name;
}

std::string quilt_ending(const QuiltName& quilt) {
  return fmt::format("_qs{}x{}a{:.6g}", quilt.tiles.columns, quilt.tiles.rows, quilt.aspect);
}

std::filesystem::path without_quilt_name(const std::filesystem::path& path) {
  std::string bare = path.stem().string();
  const auto found = pattern().search(bare);
  if (!found) return path;
  bare.erase(found->begin, found->end - found->begin);
  return path.parent_path() / (bare + path.extension().string());
}

std::filesystem::path with_quilt_name(const std::filesystem::path& path, const QuiltName& quilt) {
  const std::filesystem::path bare = without_quilt_name(path);
  return bare.parent_path() / (bare.stem().string() + quilt_ending(quilt) + bare.extension().string());
}

}  // namespace lippmann
