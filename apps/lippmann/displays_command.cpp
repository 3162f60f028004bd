// `lippmann displays`: lists the known displays, or describes one of them.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "core/printable.hpp"
#include "display/display_json.hpp"
#include "display/find_calibrations.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann::app {
namespace {

struct DisplaysOptions {
  std::string display;
  bool json = false, find = false;
  std::vector<std::string> mounts;
};

std::string quilt_text(const Display& display) {
  if (!display.quilt) return "-";
  const DisplayQuilt& quilt = *display.quilt;
  return fmt::format("{}x{} of {}x{}", quilt.columns, quilt.rows, quilt.width, quilt.height);
}

void print_list(const std::vector<Display>& displays) {
  fmt::print("{:<30} {:>11}  {:>18}  {:>5}  {:>4}  {}\n", "name", "pixels", "quilt", "views", "cone", "what it is");
  for (const Display& d : displays)
    fmt::print("{:<30} {:>11}  {:>18}  {:>5}  {:>4}  {}\n", d.name, fmt::format("{}x{}", d.pixels.x, d.pixels.y), quilt_text(d),
               views_of(d), fmt::format("{:g}°", d.view_cone_deg), d.description);
}

void print_calibration(const Display& d) {
  const Calibration& c = d.calibration;
  fmt::print("calibration      pitch {:g}, slope {:g}, center {:g}{}{}{}\n", c.pitch, c.slope, c.center,
             c.flip_image_x ? ", flipImageX" : "", c.flip_sub_pixels ? ", flipSubp" : "",
             c.cells.empty() ? "" : fmt::format(", {} sub-pixel cells by pattern {}", c.cells.size(), c.cell_pattern));
  fmt::print("lenses           {:.3f} across the panel, tilt {:.6f}, {:.2f} sub-pixels below each\n", periods_of(d), tilt_of(d),
             3.0 * d.pixels.x / periods_of(d));
}

void print_details(const Display& d) {
  const Vec2d size = d.size_mm();
  fmt::print("{}: {}\n", printable_line(d.name), printable_line(d.description));
  fmt::print("kind             {}{}\n", to_string(d.kind),
             d.serials.empty() ? "" : fmt::format(", serial {}", fmt::join(d.serials, ", ")));
  fmt::print("pixels           {}x{} at {:g} dpi: {:.1f} x {:.1f} mm\n", d.pixels.x, d.pixels.y, d.dpi, size.x, size.y);
  fmt::print("viewing          cone {:g}°, from {:.0f} mm; depth budget +-{:.1f} mm\n", d.view_cone_deg, viewing_distance_mm(d),
             depth_budget_mm(native_optics(d)));
  if (d.kind == DisplayKind::kSlantedPanel)
    print_calibration(d);
  else
    fmt::print("lenses           {:.4f} mm wide ({:g} per inch), slant {:g}°\n", d.lenses.pitch_mm, 25.4 / d.lenses.pitch_mm,
               d.lenses.slant_deg);
  if (const std::optional<Optics> quilt = quilt_optics(d))
    fmt::print("quilt            {} pixels, aspect {:g}; depth budget +-{:.1f} mm\n", quilt_text(d), d.quilt->aspect,
               depth_budget_mm(*quilt));
  fmt::print("views            {}\n", views_of(d));
  if (d.kind != DisplayKind::kLenticularSheet)
    fmt::print("video            {} up to {} pixels on a side{}\n", d.video.codec, d.video.longest_side,
               d.video.quilts ? "" : "; quilts as pictures only");
}

/// Returns the calibration in a file, or the error if it cannot be read.
nlohmann::ordered_json found_json(const std::string& file) try {
  nlohmann::ordered_json json{{"file", file}};
  json.update(display_json(load_display(file)));
  return json;
} catch (const Error& error) {
  return {{"file", file}, {"error", error.what()}};
}

void print_found(const std::string& file) try {
  const Display display = load_display(file);
  fmt::print("{}\n  {}, {}x{} pixels, quilt {}\n  lippmann render SCENE --display '{}'\n", printable_line(file),
             printable_line(display.description), display.pixels.x, display.pixels.y, quilt_text(display),
             printable_line(file));
} catch (const Error& error) {
  fmt::print("{}\n", with_flags(error.what()));
}

/// Throws Error if no device is found, unless --json is given.
int find_devices(const DisplaysOptions& options) {
  if (!options.display.empty()) throw usage_error("--find", "cannot be combined with the name of a display", "one of the two");
  const std::vector<std::filesystem::path> mounts =
      options.mounts.empty() ? usual_mount_points()
                             : std::vector<std::filesystem::path>(options.mounts.begin(), options.mounts.end());
  const std::vector<std::filesystem::path> found = find_calibrations(mounts);
  if (options.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const auto& file : found) all.push_back(found_json(file.string()));
    print_json(all);
    return 0;
  }
  if (found.empty()) {
    std::vector<std::string> looked;
    for (const auto& mount : mounts) looked.push_back(mount.string());
    throw Error("displays", fmt::format("there is no LKG_calibration/visual.json below {}", fmt::join(looked, ", ")),
                "a display whose drive is mounted, or --mounts with its folder");
  }
  for (const auto& file : found) print_found(file.string());
  return 0;
}

int run(const DisplaysOptions& options) {
  if (options.find) return find_devices(options);
  if (!options.mounts.empty()) throw usage_error("--mounts", "has no effect without --find", "--find");
  const bool one = !options.display.empty();
  const std::vector<Display> displays = one ? std::vector{load_display(options.display)} : display_presets();
  if (options.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Display& display : displays) all.push_back(display_json(display));
    print_json(one ? all.front() : all);
  } else if (one) {
    print_details(displays.front());
  } else {
    print_list(displays);
  }
  return 0;
}

}  // namespace

void add_displays_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<DisplaysOptions>();
  const Command command = root.add_command("displays", "List the known displays, or describe one of them");
  command.add_option("DISPLAY", options->display, "A name from the list, a display's .toml, or a calibration's .json");
  command.add_flag("--find", options->find, "Look for the calibrations of displays that are plugged in");
  command
      .add_option("--mounts", options->mounts,
                  "Folders in which --find looks for drives; default: /media, /run/media, /mnt and /Volumes")
      .type_name("DIR");
  command.add_flag("--json", options->json, "Print JSON on stdout");
  command.when_named([options, &chosen] { chosen = [options](Context&) { return run(*options); }; });
}

}  // namespace lippmann::app
