#include "apps/lippmann/sheet_flags.hpp"

#include <fmt/core.h>

#include <array>
#include <utility>

#include "apps/lippmann/command_line.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

constexpr const char* kWholeSheet = "--lpi (or --lenses-per-mm, --pitch-mm, --visual-lpi), --dpi and --paper";

std::array<std::pair<const char*, std::string>, 8> sheet_values(const SheetFlags& flags) {
  return {{{"lpi", flags.lpi},
           {"lenses-per-mm", flags.lenses_per_mm},
           {"pitch-mm", flags.pitch_mm},
           {"visual-lpi", flags.visual_lpi},
           {"dpi", flags.dpi},
           {"paper", flags.paper},
           {"phase", flags.phase},
           {"landscape", flags.landscape ? "yes" : ""}}};
}

}  // namespace

std::string SheetFlags::first_given() const {
  for (const auto& [key, value] : sheet_values(*this))
    if (!value.empty()) return fmt::format("--{}", key);
  return {};
}

std::string SheetFlags::line(const Others& others) const {
  const std::string given = first_given();
  if (!others.display.empty()) throw usage_error(given, "cannot be combined with --display", "one of the two");
  const auto require = [&](bool is_there, const char* what) {
    if (!is_there) throw usage_error(given, fmt::format("does not describe a sheet without {}", what), kWholeSheet);
  };
  require(!(lpi + lenses_per_mm + pitch_mm + visual_lpi).empty(), "--lpi");
  require(!dpi.empty(), "--dpi");
  require(!paper.empty(), "--paper");
  std::string text;
  for (const auto& [key, value] : sheet_values(*this))
    if (!value.empty() && value != "yes") text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
  if (landscape) text += " landscape";
  if (!others.viewing_distance_mm.empty() && others.viewing_distance_mm != "auto")
    text += " viewing-distance=" + others.viewing_distance_mm;
  if (!others.view_angle_deg.empty()) text += " view-angle=" + others.view_angle_deg;
  return text;
}

void add_sheet_flags(const Command& command, SheetFlags& flags) {
  const Command group = command.add_group("A lenticular sheet without a file", "Replaces --display");
  group.add_option("--lpi", flags.lpi, "Lenses per inch; without --viewing-distance also the pitch of the print")
      .type_name("N");
  group.add_option("--lenses-per-mm", flags.lenses_per_mm, "In place of --lpi: lenses per millimetre").type_name("N");
  group.add_option("--pitch-mm", flags.pitch_mm, "In place of --lpi: the pitch of the lenses").type_name("MM");
  group
      .add_option("--visual-lpi", flags.visual_lpi,
                  "In place of --lpi: the pitch of the print, measured with a pitch test from --viewing-distance")
      .type_name("N");
  group.add_option("--dpi", flags.dpi, "Resolution of the print").type_name("N");
  group
      .add_option("--paper", flags.paper,
                  "Size of the print: A0 to A8, letter, legal, tabloid, 148x210mm, 5x7in or 3593x2783px")
      .type_name("SIZE");
  group.add_flag("--landscape", flags.landscape, "Turn the paper so that it is wider than high");
  group
      .add_option("--phase", flags.phase,
                  "Position of a lens's left edge, in pixels from the left edge of the print; default: 0")
      .type_name("PX");
}

}  // namespace lippmann::app
