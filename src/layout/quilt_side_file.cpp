#include "layout/quilt_side_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.hpp"
#include "core/json_text.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kMaxTiles = 9999;  ///< a side, as in names

std::string text_of(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  std::error_code problem;
  if (fs::file_size(path, problem) > kMaxBytes || problem) throw Error(path.string(), "is not the side file of a quilt");
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

fs::path quilt_side_path(const fs::path& image) { return fs::path(image) += ".json"; }

std::optional<QuiltSideFile> read_quilt_side_file(const fs::path& image) {
  const fs::path path = quilt_side_path(image);
  if (!is_regular_file_there(path)) return std::nullopt;
  return parse_quilt_side_file(text_of(path), path.string());
}

std::optional<QuiltSideFile> parse_quilt_side_file(const std::string& text, const std::string& where) {
  const Json json = json_from_text(text);
  if (json.is_discarded()) throw Error(where, "is not JSON");
  if (!json.is_object() || !json.contains("quilt_settings")) return std::nullopt;
  QuiltSideFile side;
  try {
    const Json& settings = json.at("quilt_settings");
    settings.at("viewX").get_to(side.quilt.tiles.columns);
    settings.at("viewY").get_to(side.quilt.tiles.rows);
    const auto in_range = [](int n) { return n >= 1 && n <= kMaxTiles; };
    if (!in_range(side.quilt.tiles.columns) || !in_range(side.quilt.tiles.rows))
      throw Error(where, "speaks of a quilt without tiles", fmt::format("viewX and viewY from 1 to {}", kMaxTiles));
    side.views = settings.value("viewTotal", side.quilt.tiles.count());
    side.quilt.aspect = settings.value("aspect", 1.0);
    side.inverted = settings.value("invertViews", false);
  } catch (const nlohmann::json::exception&) {
    throw Error(where, "its quilt_settings are incomplete or of the wrong kind",
                "viewX, viewY, viewTotal, aspect, invertViews");
  }
  if (side.views < 1 || side.views > side.quilt.tiles.count())
    throw Error(where,
                fmt::format("speaks of {} views in {}x{} tiles", side.views, side.quilt.tiles.columns, side.quilt.tiles.rows));
  if (!(side.quilt.aspect > 0.0) || !std::isfinite(side.quilt.aspect))
    throw Error(where, "its aspect is no ratio", "a number above 0");
  return side;
}

void write_quilt_side_file(const fs::path& image, const QuiltSideFile& side) {
  const Json json{{"mediaType", "image"},
                  {"quilt_settings",
                   {{"viewX", side.quilt.tiles.columns},
                    {"viewY", side.quilt.tiles.rows},
                    {"viewTotal", side.views},
                    {"aspect", side.quilt.aspect},
                    {"invertViews", side.inverted}}}};
  const std::string text = json_to_text(json) + '\n';
  write_file_atomically(quilt_side_path(image), std::as_bytes(std::span(text)));
}

}  // namespace lippmann
