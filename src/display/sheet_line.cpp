#include "display/sheet_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "core/text_pattern.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr double kInchMm = 25.4, kDefaultAngleDeg = 50.0;

constexpr std::array<std::string_view, 4> kPitchKeys{"lpi", "lenses-per-mm", "pitch-mm", "visual-lpi"};
constexpr std::array<std::string_view, 11> kSheetKeys{"lpi",   "lenses-per-mm", "pitch-mm",  "visual-lpi",       "dpi",
                                                      "paper", "phase",         "landscape", "viewing-distance", "view-angle",
                                                      "slant"};
constexpr const char* kPapers = "A0 to A8, letter, legal, tabloid, or a size such as 148x210mm, 5x7in or 3593x2783px";

using SheetValues = std::map<std::string, std::string>;

SheetValues values_of_line(const std::string& line) {
  SheetValues values;
  std::size_t begin = 0;
  while ((begin = line.find_first_not_of(" ,", begin)) != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(" ,", begin), line.size());
    const std::string word = line.substr(begin, end - begin);
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string key = word.substr(0, equals);
    const std::vector<std::string_view> known(kSheetKeys.begin(), kSheetKeys.end());
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw usage_error("display", "a sheet has no " + shown(key) + did_you_mean(key, known),
                        "lpi=60.12 dpi=600 paper=A5, and the other keys of docs/guide/displays.md");
    if (!values.emplace(key, equals < word.size() ? word.substr(equals + 1) : "").second)
      throw usage_error(key, "is given twice", "once");
    begin = end;
  }
  return values;
}

std::optional<double> number_of(const SheetValues& values, std::string_view key, double lowest, double highest) {
  const auto found = values.find(std::string(key));
  if (found == values.end()) return std::nullopt;
  return read_number(found->second, lowest, highest, std::string(key));
}

char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::optional<Vec2d> named_paper_mm(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), lower_letter);
  if (name == "letter") return Vec2d(8.5, 11.0) * kInchMm;
  if (name == "legal") return Vec2d(8.5, 14.0) * kInchMm;
  if (name == "tabloid") return Vec2d(11.0, 17.0) * kInchMm;
  static constexpr std::array<std::array<int, 2>, 9> kSeries{
      {{841, 1189}, {594, 841}, {420, 594}, {297, 420}, {210, 297}, {148, 210}, {105, 148}, {74, 105}, {52, 74}}};
  if (name.size() != 2 || name[0] != 'a' || name[1] < '0' || name[1] > '8') return std::nullopt;
  const std::array<int, 2>& sides = kSeries[static_cast<std::size_t>(name[1] - '0')];
  return Vec2d(sides[0], sides[1]);
}

Vec2d paper_px(const std::string& paper, double dpi) {
  if (const std::optional<Vec2d> named = named_paper_mm(paper)) return *named / kInchMm * dpi;
  static const TextPattern size("([0-9.]+)x([0-9.]+)(mm|cm|in|px)", TextPattern::Letters::kEitherCase);
  const std::optional<PatternMatch> found = size.match(paper);
  if (!found) throw usage_error("paper", "there is no paper " + shown(paper), kPapers);
  const Vec2d sides(read_number(found->groups[1], 0.01, 1e5, "paper"), read_number(found->groups[2], 0.01, 1e5, "paper"));
  switch (found->groups[3][0] | 0x20) {
    case 'm':
      return sides / kInchMm * dpi;
    case 'c':
      return sides * 10.0 / kInchMm * dpi;
    case 'i':
      return sides * dpi;
    default:
      return sides;
  }
}

Vec2i print_px(const SheetValues& values, double dpi) {
  const auto paper = values.find("paper");
  if (paper == values.end()) throw usage_error("paper", "is missing: the size of the print is unknown", kPapers);
  Vec2d sides = glm::round(paper_px(paper->second, dpi));
  if (values.contains("landscape") && sides.x < sides.y) std::swap(sides.x, sides.y);
  constexpr double kMostPx = 65536.0;
  if (std::min(sides.x, sides.y) < 1.0 || std::max(sides.x, sides.y) > kMostPx)
    throw usage_error("paper", fmt::format("is {:.0f}x{:.0f} pixels at {:g} dpi", sides.x, sides.y, dpi),
                      "a print of 1 to 65536 pixels a side");
  return Vec2i(sides);
}

std::pair<std::string, double> pitch_of(const SheetValues& values) {
  std::optional<std::pair<std::string, double>> pitch;
  for (const std::string_view key : kPitchKeys) {
    const std::optional<double> number = number_of(values, key, 1e-3, 1e4);
    if (!number) continue;
    if (pitch) throw usage_error(std::string(key), "cannot be combined with `" + pitch->first + "`", "one of the two");
    const double per_mm = key == "lenses-per-mm" ? *number : *number / kInchMm;
    pitch = {std::string(key), key == "pitch-mm" ? *number : 1.0 / per_mm};
  }
  if (!pitch)
    throw usage_error("lpi", "is missing: the pitch of the lenses is unknown", "lpi, lenses-per-mm, pitch-mm or visual-lpi");
  return *pitch;
}

void check_pitch(const Display& sheet, const std::string& key) {
  const double cell = lens_strips(sheet).cell_px;
  constexpr double kRoundingPx = 1e-6;
  if (cell < 2.0 - kRoundingPx || cell > sheet.pixels.x + kRoundingPx)
    throw usage_error(key, fmt::format("makes lenses {:.3f} pixels wide on a print of {} pixels", cell, sheet.pixels.x),
                      "a pitch from 2 pixels to the width of the print");
}

std::string described(const Display& sheet) {
  const double cell = lens_strips(sheet).cell_px;
  return fmt::format(
      "Sheet of {:.4g} lenses per inch on {:.4g}x{:.4g} mm, {:g} dpi: {:.3f} pixels below each lens, a print pitch of {:.3f} "
      "lpi "
      "for lenses of {:.3f} lpi seen from {:.0f} mm",
      sheet.dpi / cell, sheet.size_mm().x, sheet.size_mm().y, sheet.dpi, cell, sheet.dpi / cell,
      kInchMm / sheet.lenses.pitch_mm, viewing_distance_mm(sheet));
}

}  // namespace

bool is_sheet_line(const std::string& text) {
  std::string ending = std::filesystem::path(text).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), lower_letter);
  return text.find('=') != std::string::npos && ending != ".toml" && ending != ".json";
}

Display display_from_line(const std::string& line) {
  const SheetValues values = values_of_line(line);
  const auto [key, pitch_mm] = pitch_of(values);
  const std::optional<double> dpi = number_of(values, "dpi", 1.0, 1e5);
  if (!dpi) throw usage_error("dpi", "is missing: the resolution of the print is unknown", "pixels per inch, such as 600");
  Display sheet;
  sheet.name = line, sheet.kind = DisplayKind::kLenticularSheet;
  sheet.dpi = *dpi, sheet.pixels = print_px(values, *dpi);
  sheet.view_cone_deg = number_of(values, "view-angle", 1.0, 150.0).value_or(kDefaultAngleDeg);
  sheet.viewing_distance_mm = number_of(values, "viewing-distance", 1.0, 1e7);
  sheet.lenses.slant_deg = number_of(values, "slant", -80.0, 80.0).value_or(0.0);
  sheet.lenses.phase_px = number_of(values, "phase", -65536.0, 65536.0).value_or(0.0);
  const bool is_of_print = key == "visual-lpi" || !sheet.viewing_distance_mm;
  if (key == "visual-lpi" && !sheet.viewing_distance_mm)
    throw usage_error("visual-lpi", "needs the distance from the eye to the lenses",
                      "`viewing-distance`, or `lpi` in place of `visual-lpi`");
  // pitch_mm is the width c of the print's strips. Each strip fills the viewing angle of its lens if the gap is g = c / (2
  // tan(angle / 2)). At distance D, the pitch of the lenses is p = c D / (D + g).
  const double gap = pitch_mm / (2.0 * std::tan(0.5 * sheet.view_cone_deg * std::numbers::pi / 180.0));
  const double distance = viewing_distance_mm(sheet);
  sheet.lenses.pitch_mm = is_of_print ? pitch_mm * distance / (distance + gap) : pitch_mm;
  check_pitch(sheet, key);
  sheet.description = described(sheet);
  return sheet;
}

}  // namespace lippmann
