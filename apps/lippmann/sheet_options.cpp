#include "apps/lippmann/sheet_options.hpp"

#include <fmt/core.h>

#include <array>

#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann::app {
namespace {

struct IdleSheetRule {
  const char* flag;
  bool (*is_given)(const SheetOptions&);
  bool (*has_effect)(const SheetOptions&);
  const char* accepted;
};

bool is_lens(const SheetOptions& o) { return o.kind() == SheetKind::kLens; }
bool is_zone(const SheetOptions& o) { return o.kind() == SheetKind::kViewingZone; }
bool has_blocks(const SheetOptions& o) { return !is_lens(o) && !is_zone(o); }

bool uses_angle(const SheetOptions& o) {
  return o.sheet.are_given() && (!has_blocks(o) || o.sheet.pitch_depends_on_angle(o.viewing_distance_mm.has_value()));
}

constexpr std::array kIdleSheetRules{
    IdleSheetRule{"--blocks", [](const SheetOptions& o) { return o.blocks.has_value(); }, has_blocks, "pitch or phase"},
    IdleSheetRule{"--step", [](const SheetOptions& o) { return !o.step.empty(); },
                  [](const SheetOptions& o) { return o.kind() == SheetKind::kPitch; }, "pitch"},
    IdleSheetRule{"--bars", [](const SheetOptions& o) { return !o.bars.empty(); }, has_blocks, "pitch or phase"},
    IdleSheetRule{"--views", [](const SheetOptions& o) { return o.views.has_value(); }, is_zone, "viewing-zone"},
    IdleSheetRule{"--to", [](const SheetOptions& o) { return !o.to.empty(); }, is_lens, "lens"},
    IdleSheetRule{"--thickness-mm", [](const SheetOptions& o) { return o.lens.thickness_mm.has_value(); }, is_lens, "lens"},
    IdleSheetRule{"--radius-mm", [](const SheetOptions& o) { return o.lens.radius_mm.has_value(); }, is_lens, "lens"},
    IdleSheetRule{"--height-mm", [](const SheetOptions& o) { return o.lens.height_mm.has_value(); }, is_lens, "lens"},
    IdleSheetRule{"--refractive-index", [](const SheetOptions& o) { return o.refractive_index.has_value(); }, is_lens, "lens"},
    IdleSheetRule{"--phase", [](const SheetOptions& o) { return !o.sheet.phase.empty(); },
                  [](const SheetOptions& o) { return !has_blocks(o); }, "viewing-zone or lens"},
    IdleSheetRule{"--viewing-distance", [](const SheetOptions& o) { return o.viewing_distance_mm.has_value(); },
                  [](const SheetOptions& o) { return o.sheet.are_given(); }, "--lpi, without --display"},
    IdleSheetRule{"--view-angle", [](const SheetOptions& o) { return o.view_angle_deg.has_value(); }, uses_angle,
                  "--lpi with viewing-zone, lens or --viewing-distance"},
};

std::string number_text(const std::optional<double>& number) { return number ? fmt::format("{}", *number) : std::string(); }

}  // namespace

SheetKind SheetOptions::kind() const {
  if (kind_name == "pitch") return SheetKind::kPitch;
  if (kind_name == "phase") return SheetKind::kPhase;
  return kind_name == "lens" ? SheetKind::kLens : SheetKind::kViewingZone;
}

int SheetOptions::block_count() const { return blocks.value_or(kind() == SheetKind::kPitch ? 21 : 12); }

PitchStep SheetOptions::pitch_step() const { return step.empty() ? PitchStep{} : read_pitch_step(step); }

BarDirection SheetOptions::bar_direction() const {
  return bars == "horizontal" ? BarDirection::kHorizontal : BarDirection::kVertical;
}

LensSpec SheetOptions::lens_spec() const {
  LensSpec spec = lens;
  spec.refractive_index = refractive_index.value_or(spec.refractive_index);
  return spec;
}

Display SheetOptions::read_sheet() const {
  if (!display.empty() && !sheet.are_given()) {
    const Display loaded = load_display(display);
    if (loaded.kind != DisplayKind::kLenticularSheet)
      throw usage_error("--display", loaded.name + " is not a lenticular sheet",
                        "a sheet's .toml, or --lpi, --dpi and --paper");
    return loaded;
  }
  SheetFlags flags = sheet;
  if (!flags.are_given()) throw usage_error("--lpi", "is missing", "--lpi and --dpi, or --display");
  if (flags.paper.empty() && !is_lens(*this)) flags.paper = "A4";
  return load_display(flags.line({display, number_text(viewing_distance_mm), number_text(view_angle_deg)}));
}

void refuse_idle_flags(const SheetOptions& options) {
  for (const IdleSheetRule& rule : kIdleSheetRules)
    if (rule.is_given(options) && !rule.has_effect(options))
      throw usage_error(rule.flag, fmt::format("has no effect on a sheet of the kind {}", options.kind_name), rule.accepted);
}

void add_sheet_options(const Command& command, SheetOptions& options) {
  command
      .add_option("KIND", options.kind_name,
                  "pitch: blocks of different pitches; phase: blocks of different phases; viewing-zone: numbered views; lens: "
                  "heights of the lenses, for UV printers that print them")
      .one_of({"pitch", "phase", "viewing-zone", "lens"})
      .required();
  command.add_option("-o,--output", options.out, "The print: .png, or .tiff except for lens").required().type_name("FILE");
  command.add_option("--display", options.display, "A lenticular sheet's .toml, in place of --lpi, --dpi and --paper")
      .type_name("FILE");
  add_sheet_flags(command, options.sheet);
  command
      .add_option("--viewing-distance", options.viewing_distance_mm,
                  "With --lpi: distance from the eye to the lenses; --lpi is then the pitch of the lenses, not of the print")
      .type_name("MM")
      .range(1.0, 1e7);
  command.add_option("--view-angle", options.view_angle_deg, "With --lpi: full angle of the viewing zone; default: 50")
      .type_name("DEG")
      .range(1.0, 150.0);
  const Command tests = command.add_group("Test prints", "Default of --paper: A4");
  tests.add_option("--blocks", options.blocks, "Number of blocks for pitch (default: 21) or phase (default: 12)")
      .type_name("N")
      .range(2, 200);
  tests
      .add_option("--step", options.step,
                  "For pitch: step from block to block around the nominal pitch in the middle, such as 0.05lpi; default: 0.1px")
      .type_name("N(px|lpi)");
  tests.add_option("--bars", options.bars, "For pitch and phase: direction of the lenses; default: vertical")
      .one_of({"vertical", "horizontal"});
  tests
      .add_option("--views", options.views,
                  "For viewing-zone: number of views; default: one per 2 pixels below a lens, at most 9")
      .type_name("N")
      .range(2, 99);
  const Command lens = command.add_group("Lenses", "For lens: one of the first three");
  lens.add_option("--thickness-mm", options.lens.thickness_mm,
                  "Distance from the top of a lens to the print; sets the radius t (n - 1) / n that focuses on the print")
      .type_name("T")
      .positive();
  lens.add_option("--radius-mm", options.lens.radius_mm, "Radius of the cylindrical caps").type_name("R").positive();
  lens.add_option("--height-mm", options.lens.height_mm, "Height of the caps").type_name("H").positive();
  lens.add_option("--refractive-index", options.refractive_index, "Refractive index of the ink or varnish; default: 1.5")
      .type_name("N")
      .range(1.01, 4.0);
  lens.add_option("--to", options.to, "height (default): a grey PNG of 16 bits, white at the top of a lens").one_of({"height"});
  add_result_flags(command, options.result);
}

}  // namespace lippmann::app
