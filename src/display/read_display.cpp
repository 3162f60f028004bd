#include "display/read_display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/json_fields.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

constexpr NumberRange kSide{1, 65536}, kTiles{1, 64}, kDpi{1, 1e5}, kCone{0.1, 175}, kAspect{0.01, 100}, kOffset{-4, 4},
    kAngle{-360, 360};
constexpr std::size_t kMaxCells = 8;

enum class Level { kFile, kLenses, kCalibration, kQuilt, kVideo };

constexpr std::array<const char*, 5> kPlaces{"the top of the file, before the first table", "[lenses]", "[calibration]",
                                             "[quilt]", "[video]"};

const std::vector<std::string_view>& keys_of(Level level) {
  static const std::array<std::vector<std::string_view>, 5> keys{
      {{"base", "description", "kind", "serials", "pixels", "dpi", "view_cone_deg", "viewing_distance_mm", "crosstalk",
        "calibration", "lenses", "quilt", "video"},
       {"pitch_mm", "lenses_per_inch", "slant_deg", "packing", "phase_px"},
       {"pitch", "slope", "center", "invView", "flipImageX", "flipImageY", "flipSubp", "verticalAngle", "fringe",
        "subpixelCells", "CellPatternMode", "configVersion", "patterns", "inversion", "flip"},
       {"tiles", "size", "aspect"},
       {"codec", "longest_side", "quilts"}}};
  return keys[static_cast<std::size_t>(level)];
}

/// Throws Error for an unknown key and for a key that belongs to another table, which the message names.
void allow_keys_of(Level level, const JsonFields& fields) {
  const std::vector<std::string_view>& own = keys_of(level);
  for (std::size_t other = 0; other < kPlaces.size(); ++other)
    for (const std::string_view key : keys_of(static_cast<Level>(other)))
      if (std::find(own.begin(), own.end(), key) == own.end() && fields.has(key))
        fields.reject(key, "is in the wrong place", std::string("this key in ") + kPlaces[other]);
  fields.allow_only(own);
}

double read_slope(const JsonFields& fields, double otherwise) {
  const double slope = fields.number_or("slope", {-1e4, 1e4}, otherwise);
  if (std::abs(slope) < 1e-3)
    fields.reject("slope", fmt::format("is {}, so the lenses lie along the rows", slope),
                  "a number from 0.001 to 10000, or its negative, such as -7");
  return slope;
}

std::vector<SubPixelCell> read_cells(const JsonFields& fields) {
  const Json& json = fields.value("subpixelCells");
  if (!json.is_array()) fields.reject("subpixelCells", "is not a list", "a list of tables with ROffsetX, ROffsetY, ...");
  if (json.size() > kMaxCells)
    fields.reject("subpixelCells", fmt::format("has {} cells", json.size()), fmt::format("at most {}", kMaxCells));
  std::vector<SubPixelCell> cells;
  for (const Json& element : json) {
    const JsonFields cell = fields.element("subpixelCells", element);
    const auto offset = [&](const char* x, const char* y) {
      return Vec2f(static_cast<float>(cell.number(x, kOffset)), static_cast<float>(cell.number(y, kOffset)));
    };
    cells.push_back({offset("ROffsetX", "ROffsetY"), offset("GOffsetX", "GOffsetY"), offset("BOffsetX", "BOffsetY")});
  }
  return cells;
}

Calibration read_calibration(const JsonFields& fields, Calibration c) {
  c.pitch = fields.number("pitch", {1e-3, 1e5});
  if (!fields.has("slope")) fields.number("slope", {-1e4, 1e4});  // throws, because the slope is missing
  c.slope = read_slope(fields, c.slope);
  c.center = fields.number("center", {-1e4, 1e4});
  c.invert = fields.flag_or("invView", c.invert);
  c.flip_image_x = fields.flag_or("flipImageX", c.flip_image_x);
  c.flip_image_y = fields.flag_or("flipImageY", c.flip_image_y);
  c.flip_sub_pixels = fields.flag_or("flipSubp", c.flip_sub_pixels);
  c.vertical_angle_deg = fields.number_or("verticalAngle", kAngle, c.vertical_angle_deg);
  c.fringe = fields.number_or("fringe", {-1e6, 1e6}, c.fringe);
  if (fields.has("subpixelCells")) c.cells = read_cells(fields);
  c.cell_pattern = fields.whole_or("CellPatternMode", {0, 4}, c.cell_pattern);
  c.version = printable(fields.text_or("configVersion", c.version));
  c.patterns =
      static_cast<Calibration::Patterns>(fields.word_or("patterns", {"columns", "rows"}, static_cast<std::size_t>(c.patterns)));
  c.inversion = static_cast<Calibration::Inversion>(
      fields.word_or("inversion", {"always", "if-flagged"}, static_cast<std::size_t>(c.inversion)));
  c.flip = static_cast<Calibration::Flip>(
      fields.word_or("flip", {"slope", "slope-and-step", "slope-step-and-center"}, static_cast<std::size_t>(c.flip)));
  return c;
}

DisplayLenses read_lenses(const JsonFields& fields) {
  allow_keys_of(Level::kLenses, fields);
  if (fields.has("pitch_mm") == fields.has("lenses_per_inch"))
    fields.reject("pitch_mm",
                  fields.has("pitch_mm") ? "is given besides lenses_per_inch" : "is missing, and so is lenses_per_inch",
                  "one of the two");
  DisplayLenses lenses;
  lenses.pitch_mm =
      fields.has("pitch_mm") ? fields.number("pitch_mm", {1e-3, 1e3}) : 25.4 / fields.number("lenses_per_inch", {0.1, 2e4});
  lenses.slant_deg = fields.number_or("slant_deg", {-89, 89}, 0.0);
  if (fields.has("phase_px")) lenses.phase_px = fields.number("phase_px", {-65536, 65536});
  lenses.packing = fields.word_or("packing", {"square", "hexagonal"}, 0) == 0 ? LensPacking::kSquare : LensPacking::kHexagonal;
  return lenses;
}

DisplayQuilt read_quilt(const JsonFields& fields, Vec2i pixels) {
  allow_keys_of(Level::kQuilt, fields);
  const Vec2i tiles = fields.whole_pair("tiles", kTiles), size = fields.whole_pair("size", kSide);
  if (size.x < tiles.x || size.y < tiles.y)
    fields.reject("size",
                  fmt::format("is {}x{}, with less than a pixel for each of {}x{} tiles", size.x, size.y, tiles.x, tiles.y),
                  "pixels across and down of all tiles together");
  const double aspect = fields.number_or("aspect", kAspect, static_cast<double>(pixels.x) / pixels.y);
  return {tiles.x, tiles.y, size.x, size.y, aspect};
}

DisplayVideo read_video(const JsonFields& fields) {
  static const std::vector<std::string_view> codecs{"h264", "hevc", "vp9", "av1", "ffv1"};
  allow_keys_of(Level::kVideo, fields);
  DisplayVideo video;
  video.codec = codecs[fields.word_or("codec", codecs, 1)];
  video.longest_side = fields.whole_or("longest_side", {16, 65536}, video.longest_side);
  video.quilts = fields.flag_or("quilts", video.quilts);
  return video;
}

double read_crosstalk_of(const JsonFields& fields) {
  if (!fields.value("crosstalk").is_string()) return fields.number("crosstalk", {0.0, kMaxBlurPx});
  try {
    return read_crosstalk(fields.text("crosstalk"), "crosstalk");
  } catch (const Error& error) {
    fields.reject("crosstalk", error.problem(), error.accepted());
  }
}

void read_optics(const JsonFields& fields, Display& display) {
  static const std::vector<std::string_view> kinds{"slanted-panel", "lenticular-sheet", "microlens-array"};
  if (!fields.has("kind")) fields.reject("kind", "is missing", "slanted-panel, lenticular-sheet or microlens-array");
  display.kind = static_cast<DisplayKind>(fields.word_or("kind", kinds, 0));
  if (display.kind != DisplayKind::kSlantedPanel) {
    display.lenses = read_lenses(fields.inner("lenses"));
    return;
  }
  const JsonFields calibration = fields.inner("calibration");
  allow_keys_of(Level::kCalibration, calibration);
  display.calibration = read_calibration(calibration, {});
}

}  // namespace

Display display_from_tables(const Json& json, const std::string& where) {
  const JsonFields fields(json, where, "");
  allow_keys_of(Level::kFile, fields);
  Display display;
  read_optics(fields, display);
  display.description = printable(fields.text_or("description", ""));
  for (const std::string& serial : fields.texts_or_none("serials")) display.serials.push_back(printable(serial));
  display.pixels = fields.whole_pair("pixels", kSide);
  display.dpi = fields.number("dpi", kDpi);
  display.view_cone_deg = fields.number("view_cone_deg", kCone);
  if (fields.has("viewing_distance_mm")) display.viewing_distance_mm = fields.number("viewing_distance_mm", {1, 1e7});
  if (fields.has("crosstalk")) display.crosstalk_px = read_crosstalk_of(fields);
  if (fields.has("quilt")) display.quilt = read_quilt(fields.inner("quilt"), display.pixels);
  if (fields.has("video")) display.video = read_video(fields.inner("video"));
  check_display(display, where);
  return display;
}

Display display_from_visual(const Json& json, const std::string& where, Display display) {
  const JsonFields fields(json, where, "");
  display.calibration = read_calibration(fields, display.calibration);
  display.pixels = {fields.whole_or("screenW", kSide, display.pixels.x), fields.whole_or("screenH", kSide, display.pixels.y)};
  display.dpi = fields.number_or("DPI", kDpi, display.dpi);
  display.view_cone_deg = fields.number_or("viewCone", kCone, display.view_cone_deg);
  check_display(display, where);
  return display;
}

void check_display(const Display& display, const std::string& where) {
  try {
    validate(native_optics(display));
    if (const std::optional<Optics> quilt = quilt_optics(display)) validate(*quilt);
  } catch (const Error& error) {
    throw Error(where, "the rays of the display's pixels cannot be computed: " + error.where() + " " + error.problem(),
                error.accepted());
  }
}

}  // namespace lippmann
