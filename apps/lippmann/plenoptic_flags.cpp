#include "apps/lippmann/plenoptic_flags.hpp"

#include "apps/lippmann/command_line.hpp"
#include "core/number_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

Vec2d read_offset(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw usage_error("--lens-offset", "'" + text + "' is not a point", "X,Y in pixels");
  return {read_number(text.substr(0, comma), -1e6, 1e6, "--lens-offset"),
          read_number(text.substr(comma + 1), -1e6, 1e6, "--lens-offset")};
}

}  // namespace

void add_plenoptic_flags(const Command& command, PlenopticFlags& flags) {
  const Command group = command.add_group(
      "Raw plenoptic pictures", "With --from plenoptic; state the lens grid by --lens-pitch-px, or let it be found in --white");
  group
      .add_option(
          "--white", flags.white,
          "A picture of uniform white light by the same camera; divides out the vignetting of each lens and gives the lens "
          "grid unless --lens-pitch-px does")
      .type_name("FILE");
  group.add_option("--lens-pitch-px", flags.pitch_px, "Distance between lenses in a row, in pixels, such as 10.135")
      .type_name("PX")
      .range(kLeastLensPitchPx, kMostLensPitchPx);
  group
      .add_option("--lens-row-pitch-px", flags.row_pitch_px,
                  "Distance between rows, in pixels; default: the pitch, or 0.866 times the pitch for hexagonal lenses")
      .type_name("PX")
      .range(kLeastLensPitchPx, kMostLensPitchPx);
  group.add_option("--lens-rotation", flags.rotation_deg, "Clockwise rotation of the rows; default: 0")
      .type_name("DEG")
      .range(-180.0, 180.0);
  group
      .add_option("--lens-offset", flags.offset,
                  "The centre of any lens, from the top left of the picture; default: half a pitch from both edges")
      .type_name("X,Y");
  group
      .add_option("--lens-arrangement", flags.arrangement,
                  "square (default) or hexagonal (every second row is shifted by half a pitch)")
      .one_of({"square", "hexagonal", "hexagonal-columns"});
  group.add_option("--sampling", flags.sampling, "Interpolation between pixels; default: linear").one_of({"linear", "lanczos"});
  group.add_flag("--inverted", flags.inverted,
                 "Rotate the pixels below each lens by 180 degrees, for lens arrays without a main lens (integral)");
}

ReadPlenopticSettings read_plenoptic_flags(const PlenopticFlags& flags) {
  PlenopticSettings settings{flags.white, flags.pitch_px, flags.row_pitch_px, flags.rotation_deg};
  if (!flags.offset.empty()) settings.offset_px = read_offset(flags.offset);
  settings.arrangement = flags.arrangement;
  settings.lanczos = flags.sampling == "lanczos", settings.inverted = flags.inverted;
  return read_plenoptic_settings(settings);
}

}  // namespace lippmann::app
