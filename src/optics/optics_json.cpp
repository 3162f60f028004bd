#include "optics/optics_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

// ---- Writing ------------------------------------------------------------------------------------------------------------

/// JSON has no infinity: null says it.
Json finite_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json model_json(const LenticularSheet& sheet) {
  return {{"kind", "lenticular"},
          {"lens_pitch_mm", sheet.lens_pitch_mm},
          {"gap_mm", sheet.gap_mm},
          {"slant_deg", degrees(sheet.slant)},
          {"offset_mm", sheet.offset_mm},
          {"viewing_distance_mm", finite_or_null(sheet.viewing_distance_mm)},
          {"eye_height_mm", sheet.eye_height_mm}};
}

Json model_json(const MicrolensArray& array) {
  return {{"kind", "microlens"},
          {"packing", array.packing == LensPacking::kSquare ? "square" : "hexagonal"},
          {"lens_pitch_mm", array.lens_pitch_mm},
          {"gap_mm", array.gap_mm},
          {"offset_mm", {array.offset_mm.x, array.offset_mm.y}},
          {"viewing_distance_mm", finite_or_null(array.viewing_distance_mm)}};
}

Json model_json(const MultiView& views) {
  Json json{{"kind", "multiview"}, {"columns", views.columns}, {"rows", views.rows}, {"distance_mm", views.distance_mm}};
  if (views.baseline_mm > 0.0f) {
    json["baseline_mm"] = views.baseline_mm;
  } else {
    json["view_cone_deg"] = degrees(views.view_cone);
    json["cone_ends_included"] = views.cone_ends_included;
  }
  if (views.pixel_height != 1.0f) json["pixel_height"] = views.pixel_height;
  return json;
}

Json model_json(const SingleView& view) {
  return {
      {"kind", "single"}, {"distance_mm", view.distance_mm}, {"pixel_offset_px", {view.pixel_offset.x, view.pixel_offset.y}}};
}

/// Rows from the bottom, columns, colours.
Json sub_pixels_json(const SubPixelOffsets& offsets) {
  Json rows = Json::array();
  for (const auto& row : offsets) {
    Json columns = Json::array();
    for (const auto& column : row) {
      Json colors = Json::array();
      for (const Vec2f offset : column) colors.push_back({offset.x, offset.y});
      columns.push_back(std::move(colors));
    }
    rows.push_back(std::move(columns));
  }
  return rows;
}

Json model_json(const SlantedPanel& slanted) {
  Json json{{"kind", "slanted"},
            {"periods", slanted.periods},
            {"tilt", slanted.tilt},
            {"center", slanted.center},
            {"inverted", slanted.inverted},
            {"view_cone_deg", degrees(slanted.view_cone)},
            {"distance_mm", slanted.distance_mm}};
  if (slanted.sub_pixels != striped_sub_pixels()) json["sub_pixel_offsets_px"] = sub_pixels_json(slanted.sub_pixels);
  return json;
}

// ---- Reading ------------------------------------------------------------------------------------------------------------

/// The members of one JSON object; every complaint names the file and the key.
class Members {
 public:
  Members(const Json& json, const std::string& where) : json_(json), where_(where) {
    if (!json.is_object()) throw Error(where, "\"optics\" is not an object");
  }

  [[noreturn]] void reject(std::string_view key, const std::string& problem, const std::string& accepted) const {
    throw Error(where_, "\"" + std::string(key) + "\" of \"optics\" " + problem, accepted);
  }

  const Json& value(std::string_view key) const {
    const auto found = json_.find(std::string(key));
    if (found == json_.end()) reject(key, "is missing", "the report.json that the render wrote");
    return *found;
  }

  bool has(std::string_view key) const { return json_.contains(std::string(key)); }

  double exact(std::string_view key, const Json& json) const {
    if (!json.is_number()) reject(key, "is not a number", "a number");
    const double value = json.get<double>();
    if (!(std::abs(value) <= 1e30)) reject(key, "is no length or angle", "a number within 1e30");
    return value;
  }
  double exact(std::string_view key) const { return exact(key, value(key)); }

  float number(std::string_view key, const Json& json) const { return static_cast<float>(exact(key, json)); }

  float number(std::string_view key) const { return number(key, value(key)); }
  float number_or(std::string_view key, float otherwise) const { return has(key) ? number(key) : otherwise; }

  float number_or_infinity(std::string_view key) const { return value(key).is_null() ? kInfinity : number(key); }

  int count(std::string_view key) const {
    const Json& json = value(key);
    if (!json.is_number_integer()) reject(key, "is not a whole number", "a whole number");
    const double exact = json.get<double>();
    if (!(exact >= 1.0 && exact <= 1e9)) reject(key, "is no count", "a whole number above 0");
    return json.get<int>();
  }

  bool flag_or(std::string_view key, bool otherwise) const {
    if (!has(key)) return otherwise;
    if (!value(key).is_boolean()) reject(key, "is neither true nor false", "true or false");
    return value(key).get<bool>();
  }

  std::string word(std::string_view key) const {
    if (!value(key).is_string()) reject(key, "is not text", "text");
    return value(key).get<std::string>();
  }

  Vec2f pair_or(std::string_view key, Vec2f otherwise) const { return has(key) ? pair(key, value(key)) : otherwise; }

  Vec2f pair(std::string_view key, const Json& json) const {
    if (!json.is_array() || json.size() != 2) reject(key, "is not a pair", "two numbers [x, y]");
    return {number(key, json[0]), number(key, json[1])};
  }

 private:
  const Json& json_;
  const std::string& where_;
};

LenticularSheet lenticular_from(const Members& json) {
  LenticularSheet sheet;
  sheet.lens_pitch_mm = json.number("lens_pitch_mm");
  sheet.gap_mm = json.number("gap_mm");
  sheet.slant = radians(json.number("slant_deg"));
  sheet.offset_mm = json.number_or("offset_mm", sheet.offset_mm);
  sheet.viewing_distance_mm = json.number_or_infinity("viewing_distance_mm");
  sheet.eye_height_mm = json.number_or("eye_height_mm", 0.0f);
  return sheet;
}

MicrolensArray microlens_from(const Members& json) {
  MicrolensArray array;
  const std::string packing = json.word("packing");
  if (packing != "square" && packing != "hexagonal")
    json.reject("packing", "is " + shown(packing), "\"square\" or \"hexagonal\"");
  array.packing = packing == "square" ? LensPacking::kSquare : LensPacking::kHexagonal;
  array.lens_pitch_mm = json.number("lens_pitch_mm");
  array.gap_mm = json.number("gap_mm");
  array.offset_mm = json.pair_or("offset_mm", array.offset_mm);
  array.viewing_distance_mm = json.number_or_infinity("viewing_distance_mm");
  return array;
}

MultiView multi_view_from(const Members& json) {
  MultiView views;
  views.columns = json.count("columns"), views.rows = json.count("rows");
  views.distance_mm = json.number("distance_mm");
  views.pixel_height = json.number_or("pixel_height", 1.0f);
  if (json.has("baseline_mm")) {
    views.baseline_mm = json.number("baseline_mm");
    return views;
  }
  views.view_cone = radians(json.number("view_cone_deg"));
  views.cone_ends_included = json.flag_or("cone_ends_included", false);
  return views;
}

/// A list of so many elements.
template <class List>
void read_list(const Members& members, const Json& json, List& list, const auto& read_element) {
  if (!json.is_array() || json.size() != list.size())
    members.reject("sub_pixel_offsets_px", "is not what it should be",
                   "4 rows of 2 columns of 3 colours of [x, y], panel pixels from the pixel's centre");
  for (std::size_t i = 0; i < list.size(); ++i) read_element(json[i], list[i]);
}

SlantedPanel slanted_from(const Members& json) {
  SlantedPanel slanted;
  slanted.periods = json.exact("periods"), slanted.tilt = json.exact("tilt"), slanted.center = json.exact("center");
  slanted.inverted = json.flag_or("inverted", true);
  slanted.view_cone = radians(json.number("view_cone_deg"));
  slanted.distance_mm = json.number("distance_mm");
  constexpr std::string_view kOffsets = "sub_pixel_offsets_px";
  if (json.has(kOffsets))
    read_list(json, json.value(kOffsets), slanted.sub_pixels, [&](const Json& row, auto& columns) {
      read_list(json, row, columns, [&](const Json& column, auto& colors) {
        read_list(json, column, colors, [&](const Json& offset, Vec2f& to) { to = json.pair(kOffsets, offset); });
      });
    });
  return slanted;
}

OpticsModel model_from(const Members& json) {
  const std::string kind = json.word("kind");
  if (kind == "lenticular") return lenticular_from(json);
  if (kind == "microlens") return microlens_from(json);
  if (kind == "multiview") return multi_view_from(json);
  if (kind == "single") return SingleView{json.number("distance_mm"), json.pair_or("pixel_offset_px", Vec2f(0.0f))};
  if (kind == "slanted") return slanted_from(json);
  json.reject("kind", "is " + shown(kind), "lenticular, microlens, multiview, single or slanted");
}

}  // namespace

Json optics_json(const Optics& optics) {
  Json json = std::visit([](const auto& model) { return model_json(model); }, optics.model);
  json["width"] = optics.panel.width;
  json["height"] = optics.panel.height;
  json["pixel_pitch_mm"] = optics.panel.pixel_pitch_mm;
  json["z_front_mm"] = finite_or_null(optics.z_front_mm);
  json["viewing_zone_deg"] = degrees(viewing_zone(optics));
  json["depth_budget_mm"] = finite_or_null(depth_budget_mm(optics));
  return json;
}

Optics optics_from_json(const Json& json, const std::string& where) {
  const Members members(json, where);
  Optics optics;
  optics.panel = {members.count("width"), members.count("height"), members.number("pixel_pitch_mm")};
  optics.model = model_from(members);
  if (members.has("z_front_mm")) optics.z_front_mm = members.number_or_infinity("z_front_mm");
  try {
    validate(optics);
  } catch (const Error& error) {
    throw Error(where, "the optics make no rays: " + error.where() + " " + error.problem(), error.accepted());
  }
  return optics;
}

}  // namespace lippmann
