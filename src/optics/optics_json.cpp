#include "optics/optics_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/json_fields.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/optics_of_kind.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

template <class Visit>
bool any_kind(const Visit& visit) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (visit(std::variant_alternative_t<i, OpticsModel>{}) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<OpticsModel>>{});
}

OpticsModel model_from(const std::string& kind, const JsonFields& json) {
  OpticsModel read;
  const bool known = any_kind([&](auto model) {
    if (kind != kind_of(model)) return false;
    read_model(json, model);
    read = std::move(model);
    return true;
  });
  if (!known) json.reject("kind", "is " + shown(kind), fmt::format("one of {}", fmt::join(optics_kind_names(), ", ")));
  return read;
}

/// "width" and "pixel_pitch_mm" describe the film, whose pixels may be sub-pixels of the panel.
Panel panel_from(const JsonFields& json, int sub_pixels) {
  const int width = json.whole("width", kAnyCount);
  if (width % sub_pixels != 0)
    json.reject("width", fmt::format("is {}, not a multiple of {} sub-pixels", width, sub_pixels),
                fmt::format("a multiple of {}", sub_pixels));
  return {width / sub_pixels, json.whole("height", kAnyCount), static_cast<float>(json.number("pixel_pitch_mm") * sub_pixels)};
}

}  // namespace

Json optics_json(const Optics& optics) {
  const int sub_pixels = sub_pixels_per_pixel(optics);
  Json json;
  std::visit([&](const auto& model) { json["kind"] = std::string(kind_of(model)), write_model(model, json); }, optics.model);
  json["width"] = film_size(optics).x;
  json["height"] = optics.panel.height;
  json["pixel_pitch_mm"] = static_cast<double>(optics.panel.pixel_pitch_mm) / sub_pixels;
  json["z_front_mm"] = finite_or_null(optics.z_front_mm);
  json["viewing_zone_deg"] = degrees(viewing_zone(optics));
  json["depth_budget_mm"] = finite_or_null(depth_budget_mm(optics));
  return json;
}

Optics optics_from_json(const Json& json, const std::string& where) {
  const JsonFields members(json, where, "optics");
  Optics optics;
  optics.model = model_from(members.text("kind"), members);
  optics.panel = panel_from(members, sub_pixels_per_pixel(optics));
  optics.z_front_mm = members.float_or("z_front_mm", kInfinity);
  try {
    validate(optics);
  } catch (const Error& error) {
    throw Error(where, "the optics are invalid: " + error.where() + " " + error.problem(), error.accepted());
  }
  return optics;
}

std::vector<std::string_view> optics_kind_names() {
  std::vector<std::string_view> names;
  any_kind([&](const auto& model) {
    names.push_back(kind_of(model));
    return false;
  });
  return names;
}

std::string_view kind_name(const Optics& optics) {
  return std::visit([](const auto& model) -> std::string_view { return kind_of(model); }, optics.model);
}

Optics optics_of_kind(const std::string& kind, const Panel& panel, const std::string& members) {
  const Json json = Json::parse(members, nullptr, false);
  if (!json.is_object()) throw Error("members", "is not a JSON object", "keys and values");
  const JsonFields fields(json, "", "");
  Optics optics;
  optics.model = model_from(kind, fields);
  fields.allow_read();
  optics.panel = panel;
  validate(optics);
  return optics;
}

}  // namespace lippmann
