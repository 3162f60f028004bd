// `lippmann align PICTURES OUT`: turns pictures shot by hand or on a slider into views.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "align/align_pictures.hpp"
#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "apps/lippmann/sheet_flags.hpp"
#include "core/number_text.hpp"
#include "core/printable.hpp"
#include "folder/claim_folder.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann::app {
namespace {

struct AlignOptions {
  std::string in, out, focus, display;
  SheetFlags sheet;
  ResultFlags result;
};

Vec2d read_focus(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos)
    throw usage_error("--focus", "'" + text + "' is not a point", "X,Y in pixels of the middle picture, such as 2000,1500");
  return {read_number(text.substr(0, comma), 0.0, 65536.0, "--focus"),
          read_number(text.substr(comma + 1), 0.0, 65536.0, "--focus")};
}

std::optional<Display> display_of(const AlignOptions& options) {
  if (options.sheet.are_given()) return load_display(options.sheet.line({options.display, "", ""}));
  if (options.display.empty()) return std::nullopt;
  return load_display(options.display);
}

void warn_of_parallax(const Parallax& parallax, const ShownParallax& shown, const Context& context) {
  const double most_px = std::max(std::abs(parallax.near_px), std::abs(parallax.far_px));
  const double lenses = most_px * shown.mm_per_px / shown.lens_mm;
  if (lenses <= shown.resolved_lenses) return;
  context.warning(fmt::format(
      "Between the first and the last view, points {} the display move by {:.1f} lens widths. With {} views, only "
      "{:.0f} are possible, so these points will look torn. Take pictures closer together, or `focus` on a point nearer to the "
      "middle of the depths.",
      std::abs(parallax.near_px) == most_px ? "in front of" : "behind", lenses, shown.views, shown.resolved_lenses));
}

void print_parallax(const Parallax& parallax, const std::optional<ShownParallax>& shown) {
  const auto print_part = [&](const char* name, double px) {
    fmt::print("{:<18}{:>8.1f} px", name, px);
    if (shown) fmt::print("{:>9.2f} mm{:>8.2f} lens widths", px * shown->mm_per_px, px * shown->mm_per_px / shown->lens_mm);
    fmt::print("\n");
  };
  print_part("parallax in front", parallax.near_px);
  print_part("parallax behind", parallax.far_px);
  print_part("total parallax", parallax.total_px());
}

nlohmann::ordered_json parallax_json(const Parallax& parallax, const std::optional<ShownParallax>& shown) {
  nlohmann::ordered_json json{{"near_px", parallax.near_px}, {"far_px", parallax.far_px}, {"total_px", parallax.total_px()}};
  if (!shown) return json;
  for (const auto& [name, px] :
       {std::pair("near", parallax.near_px), std::pair("far", parallax.far_px), std::pair("total", parallax.total_px())}) {
    json[std::string(name) + "_mm"] = px * shown->mm_per_px;
    json[std::string(name) + "_lenses"] = px * shown->mm_per_px / shown->lens_mm;
  }
  json["resolved_lenses"] = shown->resolved_lenses;
  return json;
}

nlohmann::ordered_json picture_json(const AlignedPicture& picture, Vec2i size) {
  const Vec2d centre = 0.5 * Vec2d(size), shift = picture.moved(centre) - centre;
  return {{"in", picture.in.filename().string()}, {"out", picture.out.string()},    {"rotation_deg", picture.moved.turn_deg()},
          {"scale", picture.moved.scale()},       {"shift_px", {shift.x, shift.y}}, {"residual_px", picture.residual_px}};
}

void print_result(const AlignedPictures& made, const std::optional<ShownParallax>& shown, const ResultFlags& result) {
  if (result.json) {
    nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
    for (const AlignedPicture& picture : made.pictures) pictures.push_back(picture_json(picture, made.read_size));
    print_json(nlohmann::ordered_json{{"middle", made.middle},
                                      {"window", {made.corner.x, made.corner.y, made.size.x, made.size.y}},
                                      {"focus", {made.focus.x, made.focus.y}},
                                      {"parallax", parallax_json(made.parallax, shown)},
                                      {"pictures", pictures}});
    return;
  }
  if (!result.wants_text()) return;
  double residual = 0.0;
  for (const AlignedPicture& picture : made.pictures) residual = std::max(residual, picture.residual_px);
  fmt::print("{} pictures of {}x{} pixels, cropped from {}x{}; rows agree within {:.2f} px: {} ... {}\n", made.pictures.size(),
             made.size.x, made.size.y, made.read_size.x, made.read_size.y, residual,
             printable_line(made.pictures.front().out.string()), printable_line(made.pictures.back().out.string()));
  print_parallax(made.parallax, shown);
}

int run(const AlignOptions& options, const Context& context) {
  require_no_render(options.out);
  AlignParams params{options.in, options.out};
  if (!options.focus.empty()) params.focus = read_focus(options.focus);
  const std::optional<Display> display = display_of(options);
  const AlignedPictures made = align_pictures(params, context);
  if (context.cancelled) return 0;
  std::optional<ShownParallax> shown;
  if (display) shown = shown_parallax(*display, made.size, made.pictures.size());
  if (shown) warn_of_parallax(made.parallax, *shown, context);
  print_result(made, shown, options.result);
  return 0;
}

}  // namespace

void add_align_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<AlignOptions>();
  const Command command = root.add_command(
      "align", "Align pictures shot by hand or on a slider, from left to right, into the views of a light field");
  command.add_option("PICTURES", options->in, "A folder of pictures whose names sort from left to right").required();
  command.add_option("-o,--output,OUT", options->out, "The folder for the views: view_000.png, ...").required();
  command
      .add_option("--focus", options->focus,
                  "A point of the middle picture, in pixels from its top left, that is placed on the display: it stays still "
                  "from view to view; default: the centre")
      .type_name("X,Y");
  command.add_option("--display", options->display,
                     "Print the parallax in millimetres and lens widths of this display: a name (see: lippmann displays), a "
                     "calibration .json, or a .toml of your own");
  add_sheet_flags(command, options->sheet);
  add_result_flags(command, options->result);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
