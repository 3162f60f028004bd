#include "view/field_json.hpp"

#include <nlohmann/json.hpp>

#include "core/json_fields.hpp"
#include "lippmann/trace/aovs.hpp"
#include "view/page_display.hpp"
#include "view/preview.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

const char* word_for(BeyondZone beyond) {
  switch (beyond) {
    case BeyondZone::kRepeats:
      return "repeats";
    case BeyondZone::kNextLens:
      return "next lens";
    default:
      return "stays";
  }
}

const char* word_for(PanelPicture panel) {
  switch (panel) {
    case PanelPicture::kIntegral:
      return "integral";
    case PanelPicture::kQuilt:
      return "quilt";
    default:
      return "own";
  }
}

Json axis_json(const ViewAxis& axis) {
  return {{"views", axis.count},
          {"first", axis.first},
          {"step", axis.step},
          {"by", axis.by_angle ? "angle" : "slope"},
          {"beyond", word_for(axis.beyond)}};
}

Json frame_json(const PageFrame& frame) {
  Json json{{"label", frame.label}};
  if (!frame.facts.kind.empty()) json["kind"] = frame.facts.kind;
  if (frame.facts.psnr_db) json["psnr_db"] = *frame.facts.psnr_db;
  return json;
}

Json panel_picture_json(const PageFacts& facts) {
  Json json{{"is", word_for(facts.panel)}, {"size", {facts.panel_size.x, facts.panel_size.y}}};
  if (facts.phases) json["panel"] = phases_json(*facts.phases);
  return json;
}

Json preview_json(const PageFacts& facts) {
  const std::optional<Vec2i> size = preview_view_size(facts);
  return size ? Json{size->x, size->y} : Json();
}

Json provenance_json() {
  Json infos = Json::array();
  for (const ProvenanceInfo& info : kProvenanceInfos) infos.push_back({{"name", info.name}, {"missed", info.missed}});
  return infos;
}

}  // namespace

Json field_json(const PageFacts& facts) {
  Json frames = Json::array();
  for (const PageFrame& frame : facts.frames) frames.push_back(frame_json(frame));
  return {{"title", facts.title},
          {"view_size", {facts.view_size.x, facts.view_size.y}},
          {"tiles", {facts.tiles.columns, facts.tiles.rows}},
          {"across", axis_json(facts.axes.across)},
          {"up", axis_json(facts.axes.up)},
          {"vergence_per_mm", facts.axes.vergence},
          {"window_mm",
           {{"centre", {facts.window.centre.x, facts.window.centre.y}}, {"size", {facts.window.size.x, facts.window.size.y}}}},
          {"lens_samples", {facts.lens_samples_across, facts.lens_samples_up}},
          {"panel", panel_picture_json(facts)},
          {"eye_mm", {facts.eye_mm.x, facts.eye_mm.y, facts.eye_mm.z}},
          {"depth_budget_mm", finite_or_null(facts.depth_budget_mm)},
          {"depth", facts.has_depth},
          {"provenance", facts.has_provenance ? provenance_json() : Json()},
          {"preview", preview_json(facts)},
          {"disparity_scale_mm", facts.disparity_scale_mm},
          {"frames_per_second", facts.frames_per_second},
          {"assumption", facts.assumption},
          {"frames", std::move(frames)}};
}

}  // namespace lippmann
