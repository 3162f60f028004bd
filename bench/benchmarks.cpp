#include "bench/benchmarks.hpp"

#include <CLI/CLI.hpp>

namespace lippmann::bench {
namespace {

constexpr const char* kLightRows =
    "Rows to measure: names that `lippmann-bench light --list` prints, other built-in scenes or files; default: all of the "
    "list";
constexpr const char* kAnimations =
    "Animations to measure: built-in scenes or Tachyon's teapot, room and smallballs; default: all";

void add_scenes(CLI::App& command, Request& request, const std::string& help) {
  command.add_option("SCENE,--scene", request.scenes, help)->type_name("SCENE");
}

void add_scenes_with_default(CLI::App& command, Request& request, const std::string& default_scenes) {
  add_scenes(command, request, "Scenes to measure: names of built-in scenes or files; default: " + default_scenes);
}

void add_tachyon_scenes(CLI::App& command, Request& request) {
  command.add_option("--tachyon-scenes", request.tachyon_scenes, "The folder of Tachyon's own scenes")
      ->type_name("DIR")
      ->capture_default_str();
}

void add_frames(CLI::App& command, Request& request, const std::string& default_frames) {
  command.add_option("--frames", request.frames, "Frames of each animation; default: " + default_frames)
      ->type_name("N")
      ->check(CLI::Range(1, 1'000'000));
}

void add_view_pixels(CLI::App& command, Request& request, const std::string& default_pixels) {
  command.add_option("--view-pixels", request.view_pixels, "Width and height of each view; default: " + default_pixels)
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

void add_views(CLI::App& command, Request& request) {
  command
      .add_option("--views", request.views, "Views across and up in place of each row's own; default with --view-pixels: 3x1")
      ->type_name("CxR");
  add_view_pixels(command, request, "each row's own, with --views 120");
}

void add_large(CLI::App& command, Request& request) {
  command.add_flag("--large", request.large, "Also measure the teapot at 3840x2160 pixels");
}

void add_quick(CLI::App& command, Request& request) {
  command.add_flag("--quick", request.quick, "Measure a few small frames, to check that the benchmark works");
}

void add_reference_spp(CLI::App& command, Request& request) {
  command
      .add_option("--reference-spp", request.reference_spp,
                  "Samples per pixel of the reference pictures; default: 1024, with --quick 64")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20));
}

void add_references(CLI::App& command, Request& request) {
  add_reference_spp(command, request);
  command
      .add_option("--references", request.references,
                  "The folder that keeps the reference pictures; default: lippmann/references in the user's cache")
      ->type_name("DIR");
}

void add_pictures(CLI::App& command, Request& request) {
  command
      .add_option("--pictures", request.pictures,
                  "Also write the compared pictures and their errors as PNG files into this folder")
      ->type_name("DIR");
}

}  // namespace

Error interrupted() { return {"interrupted", "the benchmark was stopped before its end"}; }

void begin_step(const Request& request, const Context& context, std::string_view what) {
  if (context.cancelled) throw interrupted();
  if (request.say) request.say(what);
}

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all{
      {"denoise", "Path-traced frames with and without denoising: PSNR, flicker from view to view, CPU time", measure_denoise,
       [](CLI::App& command, Request& request) {
         add_scenes_with_default(command, request, "teapot, room, tree");
         add_quick(command, request);
         add_references(command, request);
       }},
      {"estimates", "How often the PSNR interval reported by path-traced frames contains the true PSNR", measure_estimates,
       [](CLI::App& command, Request& request) {
         add_scenes(command, request, kLightRows);
         add_frames(command, request, "4");
         add_views(command, request);
         add_quick(command, request);
         add_references(command, request);
       }},
      {"lamps", "Path-traced frames lit by 10 to 10,000 lamps: CPU time, PSNR, and CPU time at equal PSNR", measure_lamps,
       [](CLI::App& command, Request& request) {
         add_quick(command, request);
         add_reference_spp(command, request);
       }},
      {"light", "Denoised frames of 16 samples per pixel compared with plain ones of 64: CPU time, error, mean light, flicker",
       measure_light,
       [](CLI::App& command, Request& request) {
         add_scenes(command, request, kLightRows);
         command.add_flag("--list", request.list, "List the rows and measure nothing");
         add_frames(command, request, "3, or 1 for quilts");
         add_views(command, request);
         add_quick(command, request);
         add_pictures(command, request);
         add_references(command, request);
       }},
      {"native", "The native frame of a slanted panel compared with one interlaced from 48 views: PSNR and CPU time",
       measure_native, [](CLI::App& command, Request& request) { add_scenes_with_default(command, request, "teapot, room"); }},
      {"paper", "The tables of the paper: interpolated animations compared with traced ones, and pixel-tracing styles",
       measure_paper,
       [](CLI::App& command, Request& request) {
         add_scenes(command, request, kAnimations);
         add_tachyon_scenes(command, request);
         add_frames(command, request, "48, of Tachyon's 24");
         add_large(command, request);
         command.add_option("--plot", request.plot, "Also draw plots as PNG files into this folder")->type_name("DIR");
         command.add_option("--csv", request.csv, "Also write the summary, one row per scene, as CSV")->type_name("FILE");
       }},
      {"png", "CPU time and size of a PNG file by strategy, filter and level", measure_png, [](CLI::App&, Request&) {}},
      {"rays", "Rays per second of our passes compared with bare Embree, by scene and ray order", measure_rays,
       [](CLI::App& command, Request& request) { add_scenes_with_default(command, request, "all built-in scenes"); }},
      {"replay", "Eye views through the arrays compared with direct views, by depth, and whether depth is inverted",
       measure_replay, [](CLI::App& command, Request& request) { add_scenes_with_default(command, request, "room"); }},
      {"reuse", "CPU time saved by reuse between frames, and the PSNR of its frames", measure_reuse,
       [](CLI::App& command, Request& request) {
         add_scenes(command, request, kAnimations);
         add_tachyon_scenes(command, request);
         add_frames(command, request, "48, of Tachyon's 24");
         add_large(command, request);
       }},
      {"spheres", "Rays per second for our spheres compared with Embree's sphere points", measure_spheres,
       [](CLI::App& command, Request& request) { add_scenes_with_default(command, request, "small-balls"); }},
      {"splats", "A quilt of 48 views with 100,000 and a million splats: CPU time, also relative to tracing triangles",
       measure_splats,
       [](CLI::App& command, Request& request) {
         add_view_pixels(command, request, "420 and 560");
         add_quick(command, request);
       }},
      {"tachyon", "CPU time per pixel compared with the program tachyon, on its own scenes", measure_tachyon,
       [](CLI::App& command, Request& request) {
         add_scenes(command, request, "Scenes to measure: teapot, room or smallballs; default: all three");
         add_tachyon_scenes(command, request);
       }},
  };
  return all;
}

}  // namespace lippmann::bench
