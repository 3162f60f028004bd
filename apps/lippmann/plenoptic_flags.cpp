#include "apps/lippmann/plenoptic_flags.hpp"

#include <memory>
#include <utility>

#include "apps/lippmann/command_line.hpp"
#include "core/number_text.hpp"
#include "layout/lens_grid_file.hpp"
#include "layout/plenoptic_views.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

constexpr double kLeastPitchPx = 2.0, kMostPitchPx = 4096.0;

Vec2d read_offset(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) throw usage_error("--lens-offset", "'" + text + "' is not a point", "X,Y in pixels");
  return {read_number(text.substr(0, comma), -1e6, 1e6, "--lens-offset"),
          read_number(text.substr(comma + 1), -1e6, 1e6, "--lens-offset")};
}

/// Returns the lens grid that the flags define. Without --lens-offset, the first lens is half a pitch from the left and top
/// edges.
LensGrid read_grid_flags(const PlenopticFlags& flags) {
  const LensArrangement arrangement = read_arrangement(flags.arrangement).value_or(LensArrangement::kSquare);
  const double turn = flags.rotation_deg.value_or(0.0) * std::numbers::pi / 180.0, half = 0.5 * *flags.pitch_px;
  LensGrid grid = lens_grid(*flags.pitch_px, turn, {half, half}, arrangement);
  if (flags.row_pitch_px) grid.row_pitch_px = *flags.row_pitch_px;
  if (!flags.offset.empty()) grid.offset_px = read_offset(flags.offset);
  return grid;
}

void require_pitch(const PlenopticFlags& flags) {
  const auto require = [](bool given, const char* flag) {
    if (given) throw usage_error(flag, "has no effect without --lens-pitch-px", "--lens-pitch-px, or --white alone");
  };
  require(flags.row_pitch_px.has_value(), "--lens-row-pitch-px");
  require(flags.rotation_deg.has_value(), "--lens-rotation");
  require(!flags.offset.empty(), "--lens-offset");
  require(!flags.arrangement.empty(), "--lens-arrangement");
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
      .range(kLeastPitchPx, kMostPitchPx);
  group
      .add_option("--lens-row-pitch-px", flags.row_pitch_px,
                  "Distance between rows, in pixels; default: the pitch, or 0.866 times the pitch for hexagonal lenses")
      .type_name("PX")
      .range(kLeastPitchPx, kMostPitchPx);
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

ReadPlenopticFlags read_plenoptic_flags(const PlenopticFlags& flags) {
  ReadPlenopticFlags read;
  if (!flags.pitch_px) require_pitch(flags);
  const bool are_given = flags.pitch_px || !flags.white.empty() || !flags.sampling.empty() || flags.inverted;
  if (!are_given) return read;
  PlenopticCalibration& calibration = read.calibration.emplace();
  calibration.lanczos = flags.sampling == "lanczos", calibration.inverted = flags.inverted;
  if (flags.pitch_px) calibration.grid = read_grid_flags(flags);
  if (flags.white.empty()) return read;
  auto white = std::make_shared<const Image>(read_white(flags.white));
  if (!calibration.grid) read.fit = estimate_lens_grid(*white, flags.white), calibration.grid = read.fit->grid;
  calibration.white = std::move(white);
  return read;
}

}  // namespace lippmann::app
