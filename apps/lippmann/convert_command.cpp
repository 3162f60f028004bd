// `lippmann convert IN OUT`: converts light fields between formats.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/convert_flags.hpp"
#include "apps/lippmann/grid_flag.hpp"
#include "apps/lippmann/print_json.hpp"
#include "core/printable.hpp"
#include "folder/claim_folder.hpp"
#include "formats/estimate_lens_grid.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/convert.hpp"
#include "replay/depth_frames.hpp"
#include "replay/video_views.hpp"

namespace lippmann::app {
namespace {

ConvertParams params_of(const ConvertOptions& options, std::string_view to) {
  ConvertParams params;
  params.from = options.from, params.to = to;
  params.options.views = read_grid(options.views, "--views");
  params.options.tiles = read_grid(options.quilt, "--quilt");
  if (options.aspect > 0.0) params.options.aspect = options.aspect;
  if (options.bits > 0) params.options.bits = options.bits;
  params.options.png = options.png;
  params.options.binary = options.binary;
  if (options.has_display()) params.options.display = options.read_display();
  const InterlaceParams interlace = options.filter.read();
  params.options.filter = interlace.filter, params.options.sigma_views = interlace.sigma_views;
  params.options.stereo = options.stereo.layout();
  options.depth.add_to(params.options);
  params.options.cameras = options.cameras.read();
  if (!options.crop.empty()) params.crop = read_crop(options.crop, "--crop");
  if (!options.keep.empty()) params.keep = read_kept_views(options.keep, "--keep");
  return params;
}

LightFieldHints hints_of(const ConvertOptions& options) {
  LightFieldHints hints{.from = options.from,
                        .views = read_grid(options.views, "--views"),
                        .tiles = read_grid(options.quilt, "--quilt"),
                        .view_angle_deg = options.stereo.view_angle_deg};
  if (options.has_display()) hints.display = options.read_display();
  return hints;
}

DepthConversion depth_frames_of(const ConvertOptions& options, std::string_view to, bool is_pair) {
  DepthConversion params{options.in, options.out, std::string(to), params_of(options, to).options,
                         options.stereo.view_angle_deg};
  params.ipd_mm = options.stereo.ipd_mm.value_or(kDefaultIpdMm);
  params.depth_scale = options.depth.scale.value_or(1.0);
  params.depth = options.depth.map;
  params.is_pair = is_pair;
  return params;
}

nlohmann::ordered_json lens_grid_result(const LensGridFit& fit) {
  return {{"plenoptic", lens_grid_json(fit.grid)}, {"lenses", fit.lenses}, {"residual_px", fit.residual_px}};
}

int run(const ConvertOptions& options, const Context& context) {
  require_no_render(options.out);
  warn_about_unchecked_files(options.in, context);
  const Conversion conversion = conversion_of(options);
  refuse_idle_flags(options, conversion);
  switch (conversion.kind) {
    case ConvertKind::kRotate:
    case ConvertKind::kSpoc:
      return run_orthoscopic(options.orthoscopic, options.in, options.out, options.result, context);
    case ConvertKind::kPrecompensate:
      return run_precompensate(options.crosstalk, options.display, options.in, options.out, options.result, context);
    case ConvertKind::kDepthViews:
      return run_depth_views(depth_frames_of(options, conversion.to->name, conversion.from->name == "stereo"), options.result,
                             context);
    case ConvertKind::kStereo:
      return run_stereo(options.stereo, hints_of(options), options.in, options.out, options.result, context);
    case ConvertKind::kRearrange:
    case ConvertKind::kDisplay:
      break;
  }
  ConvertParams params = params_of(options, conversion.to->name);
  params.options.warn = context.warn;
  params.threads = context.threads;
  params.icc = options.picture.icc;
  const ReadPlenopticSettings plenoptic = read_plenoptic_flags(options.plenoptic);
  params.options.plenoptic = plenoptic.calibration;
  if (conversion.is_from_video) params.read_views = read_video_views;
  if (conversion.kind == ConvertKind::kDisplay) params.display_picture = options.picture.read(options.filter.read());
  const Converted converted = convert(options.in, options.out, params);
  if (options.to == "rgbd" && converted.written.size() > 2 && options.depth.range.empty() && conversion.from->name != "rgbd")
    context.warning(
        "each frame has its own depth range, so equal greys mean different depths: set one range for all frames with "
        "--depth-range");
  if (!converted.left_out.empty())
    context.warning(
        fmt::format("not written, because {} cannot store them: {}", conversion.to->name, fmt::join(converted.left_out, "; ")));
  if (converted.lacks_cameras)
    context.warning(
        "the cameras of these views are unknown: no parameters, depth or disparity are written (lippmann render states "
        "cameras in report.json)");
  if (!converted.too_coarse.empty())
    context.warning(converted.too_coarse + ", so the print is blurred; sharp prints need a pixel for each lens");
  if (converted.lacks_depth)
    context.warning(
        "the depth of these views is unknown: no maps of depth and disparity are written (lippmann render --aov "
        "depth writes it)");
  if (options.result.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& path : converted.written) files.push_back(path.string());
    nlohmann::ordered_json result{{"views", {converted.views.columns, converted.views.rows}},
                                  {"view_size", {converted.view_size.x, converted.view_size.y}},
                                  {"files", files}};
    if (plenoptic.fit) result["lens_grid"] = lens_grid_result(*plenoptic.fit);
    if (params.display_picture) result["fitted"] = converted.fitted;
    print_json(result);
    return 0;
  }
  if (!options.result.wants_text()) return 0;
  if (plenoptic.fit) fmt::print("{}\n", lens_grid_text(*plenoptic.fit));
  if (options.sheet.are_given()) fmt::print("{}\n", params.options.display->description);
  fmt::print("{}x{} views of {}x{} pixels{}: {}{}\n", converted.views.columns, converted.views.rows, converted.view_size.x,
             converted.view_size.y, converted.fitted.empty() ? "" : ", " + converted.fitted,
             printable_line(converted.written.front().string()),
             converted.written.size() > 1 ? " ... " + printable_line(converted.written.back().string()) : "");
  return 0;
}

std::string formats_help() {
  std::string text = "Formats:\n";
  for (const LightFieldFormat& format : light_field_formats())
    text += fmt::format("  {:<10}  {}\n", format.name, with_flags(format.description));
  return text + "See docs/reference/layouts.md for each, with an example.";
}

}  // namespace

void add_convert_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ConvertOptions>();
  const Command command = root.add_command(
      "convert", "Convert light fields from one format to another, without loss, or into the picture of a display");
  command
      .add_option(
          "IN", options->in,
          "A picture or folder in the input format, a folder of views (1.jpg ... 10.jpg), a folder of several light fields "
          "(frame_0000, ...), a video whose frames are the views (--views Nx1 for N views), or an RGB-D video")
      .required();
  command
      .add_option("OUT", options->out,
                  "A picture (.png; .exr for float samples), or a folder; the name of a quilt gets its tiles and aspect")
      .required();
  command.add_option("--from", options->from, "Format of IN (see below); default: from its name or report.json")
      .type_name("FORMAT");
  command
      .add_option("--to", options->to,
                  "Format of OUT (see below); default: the picture of --display. Required without it, except with "
                  "--rotate-elemental, --spoc or --precompensate")
      .type_name("FORMAT");
  command
      .add_option(
          "--views", options->views,
          "Number of views across and up; for an integral image, the pixels below each lens; from a stereo picture, the "
          "number of views to compute between the two")
      .type_name("CxR");
  command
      .add_option("--quilt", options->quilt,
                  "Tiles of the quilt across and down; default: from its name, or as square as possible")
      .type_name("CxR");
  command.add_option("--aspect", options->aspect, "Width / height of the display, for the name of a quilt").positive();
  command
      .add_option("--keep", options->keep,
                  "Keep only these columns (from the left) and rows (from the bottom) of views, each N, A-B, A-B:STEP or all: "
                  "0-47:2, 2-6x2-6, allx4")
      .type_name("COLUMNS[xROWS]");
  command.add_option("--crop", options->crop, "Keep only this window of every view; X and Y count from the top left")
      .type_name("WxH+X+Y");
  command.add_option("--bits", options->bits, "Bits per sample of PPM files; default: as read").range(8, 16);
  command.add_flag("--binary", options->binary, "With --to colmap: write binary files in place of text");
  command.add_flag("--png", options->png, "With --to jpeg-pleno: write PNG in place of PPM files");
  command.add_option(
      "--display", options->display,
      "The display to make a picture for (integral, quilt or native), to show RGB-D pictures on, or that IN belongs to "
      "(--from native): a name (see: lippmann displays), a calibration .json, or a .toml of your own");
  add_view_filter_flags(command, options->filter, " for --display, --to native");
  add_display_picture_flags(command, options->picture);
  add_sheet_flags(command, options->sheet);
  add_orthoscopic_flags(command, options->orthoscopic);
  add_crosstalk_flags(command, options->crosstalk);
  add_stereo_flags(command, options->stereo);
  add_depth_flags(command, options->depth);
  add_camera_flags(command, options->cameras);
  add_plenoptic_flags(command, options->plenoptic);
  add_result_flags(command, options->result);
  command.footer(formats_help());
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
