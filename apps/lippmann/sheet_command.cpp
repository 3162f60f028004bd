// `lippmann sheet KIND -o FILE`: makes test prints for measuring a lenticular sheet, or a height map of its lenses.
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/sheet_options.hpp"
#include "core/folder.hpp"
#include "core/printable.hpp"
#include "folder/claim_folder.hpp"
#include "image/png.hpp"
#include "image/print_file.hpp"
#include "lippmann/core/error.hpp"
#include "sheet/test_blocks.hpp"
#include "sheet/viewing_zone.hpp"

namespace lippmann::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInchMm = 25.4;

struct SheetResult {
  std::string text;
  Json json = Json::object();
};

SheetResult write_blocks(const BlockTest& test, const Display& sheet, const std::filesystem::path& out) {
  write_print(out, test.picture, sheet.dpi);
  const TestBlock &first = test.blocks.front(), &last = test.blocks.back();
  SheetResult result;
  const std::string range = first.pitch_px == last.pitch_px
                                ? fmt::format("phases of {:.5g} to {:.5g} pixels", first.phase_px, last.phase_px)
                                : fmt::format("{:.5g} to {:.5g} pixels below a lens, {:.5g} to {:.5g} lpi", first.pitch_px,
                                              last.pitch_px, sheet.dpi / first.pitch_px, sheet.dpi / last.pitch_px);
  result.text = fmt::format("{} blocks: {}", test.blocks.size(), range);
  Json blocks = Json::array();
  for (const TestBlock& block : test.blocks)
    blocks.push_back({{"pitch_px", block.pitch_px},
                      {"lpi", sheet.dpi / block.pitch_px},
                      {"phase_px", block.phase_px},
                      {"box", {block.bars.from.x, block.bars.from.y, block.bars.to.x, block.bars.to.y}}});
  result.json["blocks"] = blocks;
  return result;
}

SheetResult write_viewing_zone(const ViewingZoneTest& test, const Display& sheet, const std::filesystem::path& out) {
  write_print(out, test.picture, sheet.dpi);
  return {fmt::format("{} views over {:g} degrees, seen from {:.0f} mm", test.angles_deg.size(), sheet.view_cone_deg,
                      viewing_distance_mm(sheet)),
          Json{{"angles_deg", test.angles_deg}}};
}

SheetResult write_lens(const LensShape& shape, const Display& sheet, const std::filesystem::path& out, const ThreadPool& pool) {
  PngOptions png;
  png.dots_per_inch = sheet.dpi;
  write_png(out, lens_heights(sheet, shape, pool), png);
  return {
      fmt::format("Lenses {:.4f} mm wide ({:.3f} lpi), radius {:.4f} mm; white is {:.4f} mm above black; in focus {:.4f} mm "
                  "below their tops, over {:.1f} degrees",
                  shape.pitch_mm, kInchMm / shape.pitch_mm, shape.radius_mm, shape.height_mm, shape.thickness_mm,
                  shape.view_angle_deg),
      Json{{"pitch_mm", shape.pitch_mm},
           {"radius_mm", shape.radius_mm},
           {"height_mm", shape.height_mm},
           {"thickness_mm", shape.thickness_mm},
           {"view_angle_deg", shape.view_angle_deg}}};
}

SheetResult write_sheet(const SheetOptions& options, const Display& sheet, const std::filesystem::path& out,
                        const ThreadPool& pool) {
  const SheetKind kind = options.kind();
  if (kind == SheetKind::kLens) return write_lens(lens_shape(sheet.lenses.pitch_mm, options.lens_spec()), sheet, out, pool);
  if (kind == SheetKind::kViewingZone)
    return write_viewing_zone(viewing_zone_test(sheet, options.views.value_or(default_zone_views(sheet)), pool), sheet, out);
  const BlockTest test = kind == SheetKind::kPitch
                             ? pitch_test(sheet, options.block_count(), options.pitch_step(), options.bar_direction(), pool)
                             : phase_test(sheet, options.block_count(), options.bar_direction(), pool);
  return write_blocks(test, sheet, out);
}

int run(const SheetOptions& options, const Context& context) {
  refuse_idle_flags(options);
  const Display sheet = options.read_sheet();
  std::filesystem::path out = options.out;
  if (!out.has_extension()) out.replace_extension(".png");
  require_no_render(out);
  if (options.kind() == SheetKind::kLens && out.extension() != ".png")
    throw usage_error("--output", out.string() + ": 16-bit heights are written only as PNG", "a name that ends in .png");
  const ThreadPool pool(resolved_threads(context));
  const NewFolder folder(out.parent_path());
  SheetResult result = write_sheet(options, sheet, out, pool);
  if (options.result.json) {
    Json json{{"file", out.string()}, {"size", {sheet.pixels.x, sheet.pixels.y}}, {"dpi", sheet.dpi}};
    json.update(result.json);
    print_json(json);
  } else if (options.result.wants_text()) {
    if (options.sheet.are_given()) fmt::print("{}\n", sheet.description);
    fmt::print("{}: {}\n", result.text, printable_line(out.string()));
  }
  return 0;
}

}  // namespace

void add_sheet_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<SheetOptions>();
  const Command command =
      root.add_command("sheet", "Make test prints for measuring a lenticular sheet, or a height map for printing its lenses");
  add_sheet_options(command, *options);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
