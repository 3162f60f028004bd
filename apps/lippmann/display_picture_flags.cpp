#include "apps/lippmann/display_picture_flags.hpp"

#include <algorithm>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "core/number_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {
namespace {

std::vector<double> read_shares(const std::string& text) {
  std::vector<double> shares;
  for (std::size_t begin = 0; !text.empty() && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    shares.push_back(read_number(text.substr(begin, end - begin), 1e-3, 1e3, "--shares"));
    begin = end + 1;
  }
  return shares;
}

}  // namespace

DisplayPictureParams DisplayPictureFlags::read(const InterlaceParams& interlace) const {
  DisplayPictureParams params;
  if (fit == "crop") params.fit = AspectFit::kCrop;
  if (fit == "pad") params.fit = AspectFit::kPad;
  if (fit == "stretch") params.fit = AspectFit::kStretch;
  params.filter = interlace.filter, params.sigma_views = interlace.sigma_views;
  if (flip) params.flip = FlipParams{read_shares(shares), blend.value_or(0.0)};
  params.finish = {bleed_mm.value_or(0.0), marks, proof};
  params.mirror = mirror;
  params.view_shift_px = view_shift_px.value_or(0.0);
  params.turn_deg = turn_deg.value_or(0);
  if (params.turn_deg % 90 != 0) throw usage_error("--rotate", "is not a multiple of 90 degrees", "90, 180 or 270");
  return params;
}

void add_display_picture_flags(const Command& command, DisplayPictureFlags& flags) {
  const Command group = command.add_group("Pictures of a display", "With --display, or --lpi, --dpi and --paper");
  group
      .add_option(
          "--fit", flags.fit,
          "How to fit views to a display of another shape: crop, pad or stretch; default: stretch for native frames, else crop")
      .one_of({"crop", "pad", "stretch"});
  group
      .add_option("--view-shift", flags.view_shift_px,
                  "Shift the shown part of each view by this many pixels to the right per view, which moves the zero plane: "
                  "positive values bring the scene forward")
      .type_name("PX")
      .range(-1e4, 1e4);
  group.add_flag("--flip", flags.flip,
                 "Make a flip print: the pictures of IN are frames; the first lies leftmost below each lens");
  group.add_option("--shares", flags.shares, "With --flip: the relative width of each frame, such as 2,1,1; default: equal")
      .type_name("N,N,...");
  group
      .add_option("--blend", flags.blend,
                  "With --flip: width of soft transitions, relative to the narrower frame, up to 1 (morph); default: 0 (hard)")
      .range(0.0, 1.0);
  group.add_flag("--mirror", flags.mirror, "Mirror the print left to right, for the back of a sheet");
  group.add_option("--rotate", flags.turn_deg, "Turn the print clockwise by 90, 180 or 270 degrees")
      .type_name("DEG")
      .range(90, 270);
  group
      .add_option("--icc", flags.icc,
                  "Convert colours to this ICC profile of the printer, RGB or CMYK (relative colorimetric, with black point "
                  "compensation); CMYK needs a .tiff as OUT; default: sRGB")
      .type_name("FILE");
  group
      .add_option("--bleed-mm", flags.bleed_mm,
                  "Width by which the picture extends beyond each cut edge of a print; default: 0")
      .type_name("MM")
      .range(0.01, 100.0);
  group.add_flag("--marks", flags.marks,
                 "Add crop marks, registration marks, and bands that turn black when the sheet is aligned");
  group.add_flag("--proof", flags.proof, "Write only the middle square inch of a print, with unchanged pixels");
}

}  // namespace lippmann::app
