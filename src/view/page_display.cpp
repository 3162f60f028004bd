#include "view/page_display.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "optics/slanted_panel.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// Returns an array with the indices [row from the bottom, modulo 4][column modulo 2][red, green, blue][x, y].
Json offsets_json(const SubPixelOffsets& offsets) {
  Json rows = Json::array();
  for (const auto& row : offsets) {
    Json columns = Json::array();
    for (const auto& pixel : row) {
      Json colors = Json::array();
      for (const Vec2f& offset : pixel) colors.push_back({static_cast<double>(offset.x), static_cast<double>(offset.y)});
      columns.push_back(std::move(colors));
    }
    rows.push_back(std::move(columns));
  }
  return rows;
}

const char* word_for(ViewFilter filter) {
  if (filter == ViewFilter::kNearest) return "nearest";
  return filter == ViewFilter::kLinear ? "linear" : "gaussian";
}

}  // namespace

void require_one_row(const PageFacts& facts) {
  if (facts.grid.rows != 1)
    throw usage_error(
        "views", fmt::format("{} has {}x{} views, but a panel shows one row", facts.title, facts.grid.columns, facts.grid.rows),
        "one row of views; `lippmann convert` with `keep` selects one");
}

Json phases_json(const ViewPhases& phases) {
  return {{"periods", phases.periods},
          {"tilt", phases.tilt},
          {"center", phases.center},
          {"inverted", phases.inverted},
          {"sub_pixels", offsets_json(phases.sub_pixels)}};
}

Json page_display_json(const PageDisplay& shown) {
  const Display& display = shown.display;
  return {{"name", display.name},
          {"pixels", {display.pixels.x, display.pixels.y}},
          {"panel", phases_json(view_phases_of(slanted_panel(display, viewing_distance_mm(display))))},
          {"filter", word_for(shown.interlace.filter)},
          {"sigma_views", shown.interlace.sigma_views}};
}

PageDisplay dropped_calibration(std::string_view text, const InterlaceParams& otherwise) {
  PageDisplay dropped{display_from_calibration(text, "the calibration"), otherwise};
  dropped.display.name = dropped.display.serials.empty() ? "a calibrated panel" : dropped.display.serials.front();
  return dropped;
}

}  // namespace lippmann
