// `lippmann replay IN`: shows what eyes see of a rendered light field through its lenses.
#include <fmt/core.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/light_field_flags.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/crosstalk.hpp"
#include "replay/replay.hpp"

namespace lippmann::app {
namespace {

struct ReplayOptions {
  ReplayParams params;
  std::string in, folder, size, refocus, focal_stack, filter, format = "png", video, crosstalk;
  std::vector<double> eye;
  LightFieldFlags field;
  int threads = 0;
  ResultFlags result;
};

void read_size(const std::string& text, ReplayParams& params) {
  if (text.empty()) return;
  params.one_per_lens = text == "lenses";
  int read = 0;
  Vec2i& size = params.view.size;
  if (params.one_per_lens) return;
  if (std::sscanf(text.c_str(), "%7dx%7d%n", &size.x, &size.y, &read) != 2 || read != static_cast<int>(text.size()) ||
      size.x < 1 || size.y < 1)
    throw usage_error("--size", "'" + text + "' is not a size", "WxH in pixels, or the word lenses for one pixel per lens");
}

/// Returns the plane for a depth in mm, or for a disparity with the unit px; nullopt if `text` is neither.
std::optional<FocusPlane> parse_focus_plane(const std::string& text) {
  FocusPlane plane;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, plane.value);
  plane.in_px = std::string_view(rest, static_cast<std::size_t>(end - rest)) == "px";
  if (problem != std::errc() || !(rest == end || plane.in_px)) return std::nullopt;
  return plane;
}

std::optional<FocusPlane> read_refocus(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const std::optional<FocusPlane> plane = parse_focus_plane(text);
  if (!plane)
    throw usage_error("--refocus", "'" + text + "' is not a depth",
                      "a depth in mm, or a disparity from view to view such as 1.5px");
  return plane;
}

std::optional<FocalStack> read_focal_stack(const std::string& text) {
  if (text.empty()) return std::nullopt;
  FocalStack stack;
  const std::size_t first = text.find(':'), second = text.find(':', first + 1);
  if (second != std::string::npos) {
    const std::optional<FocusPlane> from = parse_focus_plane(text.substr(0, first)),
                                    to = parse_focus_plane(text.substr(first + 1, second - first - 1));
    const char* end = text.data() + text.size();
    const auto [rest, problem] = std::from_chars(text.data() + second + 1, end, stack.count);
    if (from && to && from->in_px == to->in_px && problem == std::errc() && rest == end && stack.count >= 2 &&
        stack.count <= 1000) {
      stack.first = from->value, stack.last = to->value, stack.in_px = from->in_px;
      return stack;
    }
  }
  throw usage_error("--focal-stack", "'" + text + "' is not a focal stack",
                    "Z0:Z1:N, two depths in mm or two disparities such as -2px:2px:9, and 2 to 1000 pictures");
}

void refuse_idle_flags(const ReplayOptions& options) {
  const ReplayParams& params = options.params;
  const bool refocuses = !options.refocus.empty() || !options.focal_stack.empty(),
             has_epi = params.epi_row || params.epi_column;
  const bool looks = params.ipd_mm || params.sweep > 0 || !(refocuses || has_epi);
  constexpr const char* kEyeViews = "--ipd or --sweep, or no --refocus, --focal-stack, --epi and --epi-column";
  const struct {
    const char* flag;
    bool is_given, has_effect;
    const char *without, *accepted;
  } rules[] = {{"--eye", !options.eye.empty(), looks, "without eye views", kEyeViews},
               {"--pupil", params.view.pupil_mm != 0.0, looks, "without eye views", kEyeViews},
               {"--crosstalk", !options.crosstalk.empty(), looks, "without eye views", kEyeViews},
               {"--focus", params.view.focus_mm != 0.0, looks && params.view.pupil_mm > 0.0, "on eye views through a pinhole",
                "--pupil above 0"},
               {"--filter", !options.filter.empty(), looks || has_epi, "on refocused pictures",
                "--epi, --epi-column, --ipd or --sweep, or no --refocus and --focal-stack"},
               {"--size", !options.size.empty(), looks || refocuses, "on epipolar-plane images",
                "--refocus, --focal-stack, --ipd or --sweep, or no --epi and --epi-column"},
               {"--fps", params.frames_per_second.has_value(), !options.video.empty(), "without a video", "--video"}};
  for (const auto& rule : rules)
    if (rule.is_given && !rule.has_effect)
      throw usage_error(rule.flag, fmt::format("has no effect {}", rule.without), rule.accepted);
}

ReplayParams params_of(const ReplayOptions& options) {
  ReplayParams params = options.params;
  params.in = options.in, params.field = options.field.read();
  params.folder = options.folder, params.video = options.video;
  params.exr = options.format == "exr";
  params.view.filter = options.filter == "nearest" ? SampleFilter::kNearest : SampleFilter::kLinear;
  if (!options.eye.empty()) params.eye_mm = Vec3d(options.eye[0], options.eye[1], options.eye[2]);
  params.refocus = read_refocus(options.refocus);
  params.focal_stack = read_focal_stack(options.focal_stack);
  if (!options.crosstalk.empty()) params.view.crosstalk_px = read_crosstalk(options.crosstalk, "--crosstalk");
  read_size(options.size, params);
  return params;
}

std::string eye_text(const Replayed& result) {
  if (!result.eye_mm) return {};
  return fmt::format("eye at ({:.4g}, {:.4g}, {:.4g}) mm: ", result.eye_mm->x, result.eye_mm->y, result.eye_mm->z);
}

void print_result(const Replayed& result) {
  nlohmann::ordered_json files = nlohmann::ordered_json::array(), eye;
  for (const auto& path : result.written) files.push_back(path.string());
  if (result.eye_mm) eye = {result.eye_mm->x, result.eye_mm->y, result.eye_mm->z};
  print_json({{"eye_mm", eye}, {"out_of_zone", result.out_of_zone}, {"files", files}});
}

int run(const ReplayOptions& options, Context& context) {
  refuse_idle_flags(options);
  context.threads = options.threads;
  warn_about_unchecked_files(options.in, context);
  const Replayed result = replay(params_of(options), context);
  if (options.result.json)
    print_result(result);
  else if (options.result.wants_text() && !result.written.empty())
    fmt::print("{}{}{}\n", eye_text(result), printable_line(result.written.front().string()),
               result.written.size() > 1 ? " ... " + printable_line(result.written.back().string()) : "");
  return 0;
}

void add_eye_flags(const Command& command, ReplayOptions& options) {
  const Command group = command.add_group("Eye");
  group
      .add_option("--eye", options.eye,
                  "Position of the eye in mm from the centre of the display; default: the intended viewing position")
      .values(3, ',')
      .type_name("X,Y,Z");
  group.add_option("--pupil", options.params.view.pupil_mm, "Diameter of the pupil; 0: a pinhole").type_name("MM");
  group.add_option("--focus", options.params.view.focus_mm, "Depth at which the eye is focused; default: the display")
      .type_name("MM");
  group
      .add_option("--crosstalk", options.crosstalk,
                  "Blur of the lenses: sigma of a Gaussian in pixels (quilts: in views), or the share of each "
                  "neighbour: 0.4 or 10%")
      .type_name("PIXELS|C%");
  group
      .add_option("--filter", options.filter,
                  "Interpolation between the pixels below one lens and between views: linear (default) or nearest")
      .one_of({"linear", "nearest"});
  group.add_option("--size", options.size, "Size of the pictures; 'lenses' gives one sample per lens; default: square pixels")
      .type_name("WxH");
}

void add_refocus_flags(const Command& command, ReplayOptions& options) {
  const Command group = command.add_group("Refocusing");
  group
      .add_option(
          "--refocus", options.refocus,
          "Refocus at this depth (positive in front of the lenses), or where points move by this many pixels from view to "
          "view (1.5px)")
      .type_name("MM|PXpx");
  group
      .add_option("--focal-stack", options.focal_stack,
                  "Write N pictures focused at depths from Z0 to Z1, or at disparities (-2px:2px:9)")
      .type_name("Z0:Z1:N");
  group.add_flag("--all-in-focus", options.params.all_in_focus,
                 "Take every pixel from the sharpest picture of a focal stack, and write its depth");
  group.add_option("--epi", options.params.epi_row, "The epipolar-plane image of a row, from the top of the picture")
      .type_name("ROW");
  group
      .add_option("--epi-column", options.params.epi_column,
                  "The epipolar-plane image of a column, for displays with vertical parallax")
      .type_name("COLUMN");
}

}  // namespace

void add_replay_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ReplayOptions>();
  const Command command = root.add_command("replay", "Show what an eye sees of a light field on its display, and refocus it");
  command.footer("Lengths are in millimetres of the display, whose lens plane is z = 0; see docs/guide/replay.md.");
  command
      .add_option("IN", options->in, "A rendered picture, a folder of frames, or any light field that `lippmann convert` reads")
      .required();
  command.add_option("-o,--output", options->folder, "Folder for the results; default: a folder 'replay' beside the pictures")
      .type_name("DIR");
  add_eye_flags(command, *options);
  command.add_option("--ipd", options->params.ipd_mm, "Render two eyes at this distance: left, right, and both side by side")
      .type_name("MM");
  command.add_option("--sweep", options->params.sweep, "Render N eyes from one end of the viewing zone to the other")
      .type_name("N")
      .range(1, 100000);
  add_refocus_flags(command, *options);
  command.add_option("--video", options->video, "Also write a video (.mp4, .mov, .webm, .mkv) of the views, pairs or sweep")
      .type_name("FILE");
  command.add_option("--fps", options->params.frames_per_second, "Frames per second of the video; default: as rendered")
      .type_name("N")
      .range(0.01, 1000.0);
  command.add_option("--format", options->format, "File format of the pictures: png (8-bit sRGB) or exr (linear)")
      .one_of({"png", "exr"})
      .show_default();
  add_light_field_flags(command, options->field);
  add_report_flags(command, options->field, "");
  command.add_option("--threads", options->threads, "Worker threads; 0: one per processor").range(0, 4096);
  add_result_flags(command, options->result);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
