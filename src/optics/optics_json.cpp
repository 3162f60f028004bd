#include "optics/optics_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/json_fields.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

/// Calls visit(model) for a default model of every kind, until one returns true.
template <class Visit>
bool any_kind(const Visit& visit) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (visit(std::variant_alternative_t<i, OpticsModel>{}) || ...);
  }
  (std::make_index_sequence<std::variant_size_v<OpticsModel>>{});
}

std::string all_kinds() {
  std::string kinds;
  any_kind([&](const auto& model) {
    kinds += (kinds.empty() ? "" : ", ") + std::string(kind_of(model));
    return false;
  });
  return kinds;
}

OpticsModel model_from(const JsonFields& json) {
  const std::string kind = json.text("kind");
  OpticsModel read;
  const bool known = any_kind([&](auto model) {
    if (kind != kind_of(model)) return false;
    read_model(json, model);
    read = std::move(model);
    return true;
  });
  if (!known) json.reject("kind", "is " + shown(kind), "one of " + all_kinds());
  return read;
}

/// Reports give the film: its width, and how far apart its pixels are.
Panel panel_from(const JsonFields& json, int sub_pixels) {
  const int width = json.whole("width", kAnyCount);
  if (width % sub_pixels != 0)
    json.reject("width", fmt::format("is {}, which is no whole number of pixels of {} sub-pixels", width, sub_pixels),
                fmt::format("{} sub-pixels for each pixel of the panel", sub_pixels));
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
  optics.model = model_from(members);
  optics.panel = panel_from(members, sub_pixels_per_pixel(optics));
  optics.z_front_mm = members.float_or("z_front_mm", kInfinity);
  try {
    validate(optics);
  } catch (const Error& error) {
    throw Error(where, "the optics make no rays: " + error.where() + " " + error.problem(), error.accepted());
  }
  return optics;
}

}  // namespace lippmann
