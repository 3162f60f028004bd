#include "formats/quilt_side_file.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Largest number of tiles across or down, as in file names of quilts.
constexpr int kMaxTiles = 9999;

constexpr std::string_view kOwnTable = "quilt_settings", kGrid = "grid";

/// Key of the table that describes the quilt; empty: the document itself is the table.
std::string_view settings_table(const Json& json) {
  if (json.contains(kOwnTable)) return kOwnTable;
  return json.contains("quilt") && json["quilt"].is_object() ? "quilt" : "";
}

struct TileKeys {
  std::string_view columns, rows;
};

/// Returns the two keys of `settings` that state the numbers of tiles. If there are no such keys, returns viewX and viewY if
/// `is_quilt`, otherwise none.
std::optional<TileKeys> tile_keys(const JsonFields& settings, bool is_quilt) {
  constexpr TileKeys kOwn{"viewX", "viewY"};
  for (const TileKeys keys : {kOwn, TileKeys{"columns", "rows"}, TileKeys{"quiltCols", "quiltRows"}})
    if (settings.has(keys.columns) && settings.has(keys.rows)) return keys;
  return is_quilt ? std::optional(kOwn) : std::nullopt;
}

/// Returns the grid of the views, or none if the document states no grid.
std::optional<ViewGrid> grid_in(const JsonFields& document, int views) {
  if (!document.has(kGrid)) return std::nullopt;
  const JsonFields fields = document.inner(kGrid);
  const NumberRange side{1, kMaxTiles};
  const ViewGrid grid{fields.whole("columns", side), fields.whole("rows", side)};
  if (grid.count() != views)
    document.reject(kGrid, fmt::format("has {}x{} views, but the quilt has {}", grid.columns, grid.rows, views),
                    "as many views as the quilt");
  return grid;
}

std::string text_of(const fs::path& path) {
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  return read_recorded_text(path, kMaxBytes, "the side file of a quilt");
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
  if (json.is_discarded()) throw Error(where, "is not JSON", std::string(kQuiltSideFileExample));
  if (!json.is_object()) return std::nullopt;
  const std::string_view table = settings_table(json);
  const JsonFields document(json, where, "");
  const JsonFields settings = table.empty() ? document : document.inner(table);
  const std::optional<TileKeys> keys = tile_keys(settings, table == kOwnTable);
  if (!keys) return std::nullopt;
  const NumberRange tiles{1, kMaxTiles};
  QuiltSideFile side;
  side.quilt.tiles = {settings.whole(keys->columns, tiles), settings.whole(keys->rows, tiles)};
  side.views = settings.whole_or("viewTotal", {1.0, static_cast<double>(side.quilt.tiles.count())}, side.quilt.tiles.count());
  side.quilt.aspect = settings.number_or("aspect", {1e-6, 1e6}, 1.0);
  side.inverted = settings.flag_or("invertViews", false);
  if (table == kOwnTable) side.grid = grid_in(document, side.views);
  return side;
}

void write_quilt_side_file(const fs::path& image, const QuiltSideFile& side) {
  Json json{{"mediaType", "image"},
            {kOwnTable,
             {{"viewX", side.quilt.tiles.columns},
              {"viewY", side.quilt.tiles.rows},
              {"viewTotal", side.views},
              {"aspect", side.quilt.aspect},
              {"invertViews", side.inverted}}}};
  if (side.grid && side.grid->rows > 1) json[kGrid] = {{"columns", side.grid->columns}, {"rows", side.grid->rows}};
  const std::string text = json_to_text(json) + '\n';
  write_file_atomically(quilt_side_path(image), std::as_bytes(std::span(text)));
}

}  // namespace lippmann
