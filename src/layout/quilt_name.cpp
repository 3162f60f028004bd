#include "layout/quilt_name.hpp"

#include <fmt/format.h>

#include <charconv>
#include <regex>
#include <string>

#include "core/error.hpp"

namespace lippmann {
namespace {

const std::regex& pattern() {
  static const std::regex quilt("_qs([0-9]{1,4})x([0-9]{1,4})a([0-9]*\\.?[0-9]+)(?:z[0-9.]+)?(?:f-?[0-9.]+)?$");
  return quilt;
}

template <class Number>
Number read(const std::string& digits) {
  Number value{};
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

}  // namespace

std::optional<QuiltName> parse_quilt_name(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  std::smatch found;
  if (!std::regex_search(stem, found, pattern())) return std::nullopt;
  const QuiltName name{{read<int>(found[1]), read<int>(found[2])}, read<double>(found[3])};
  if (name.tiles.columns < 1 || name.tiles.rows < 1 || !(name.aspect > 0.0))
    throw Error(path.string(), "its name speaks of a quilt without tiles or aspect", "a name such as room_qs8x6a0.75.png");
  return name;
}

std::string quilt_ending(const QuiltName& quilt) {
  return fmt::format("_qs{}x{}a{:.6g}", quilt.tiles.columns, quilt.tiles.rows, quilt.aspect);
}

std::filesystem::path with_quilt_name(const std::filesystem::path& path, const QuiltName& quilt) {
  const std::string bare = std::regex_replace(path.stem().string(), pattern(), "");
  return path.parent_path() / (bare + quilt_ending(quilt) + path.extension().string());
}

}  // namespace lippmann
