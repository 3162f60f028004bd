#include "replay/orthoscopic.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "image/picture_file.hpp"
#include "optics/optics_json.hpp"
#include "replay/rendered_frames.hpp"
#include "replay/rotate_elemental.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

SpocDisplay display_as_recorded(const Optics& recorded) {
  const auto of = [&](const auto& model, double cell_px) {
    return SpocDisplay{model.lens_pitch_mm, model.gap_mm, static_cast<int>(std::clamp(std::round(cell_px), 1.0, 4096.0))};
  };
  const double m = recorded.panel.pixel_pitch_mm;
  if (const auto* sheet = std::get_if<LenticularSheet>(&recorded.model))
    return of(*sheet, sheet->lens_pitch_mm / std::cos(double{sheet->slant}) / m);
  if (const auto* array = std::get_if<MicrolensArray>(&recorded.model)) return of(*array, array->lens_pitch_mm / m);
  throw usage_error("--spoc", "the picture was not recorded by a lens array", "pictures of --optics lenticular or microlens");
}

struct Conversion {
  Optics optics;
  PixelMap map;
};

Conversion make_conversion(const OrthoscopicParams& params, const RenderedFrames& frames) {
  if (!params.spoc) return {frames.optics, rotated_elemental_images(frames.optics, frames.files.front().string())};
  SpocDisplay display = display_as_recorded(frames.optics);
  display.lens_pitch_mm = params.lens_pitch_mm.value_or(display.lens_pitch_mm);
  display.gap_mm = params.gap_mm.value_or(display.gap_mm);
  display.pixels = params.lens_pixels.value_or(display.pixels);
  const Optics optics = spoc_display(frames.optics, display);
  return {optics, spoc(frames.optics, optics, *params.spoc)};
}

void write_report(const fs::path& path, const OrthoscopicParams& params, const RenderedFrames& frames, const Optics& optics) {
  nlohmann::ordered_json made{{"from", params.in.string()}, {"by", params.spoc ? "spoc" : "rotated elemental images"}};
  if (params.spoc) made["distance_mm"] = params.spoc->distance_mm, made["reference_mm"] = params.spoc->reference_mm;
  const nlohmann::ordered_json report{
      {"optics", optics_json(optics)}, {"settings", {{"fps", frames.frames_per_second}}}, {"made", std::move(made)}};
  const std::string text = report.dump(2) + "\n";
  write_file_atomically(path, std::as_bytes(std::span(text)));
}

void make_folder(const fs::path& folder, const fs::path& in) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) throw Error(folder.string(), "the folder cannot be made (" + problem.message() + ")");
  if (fs::equivalent(folder, in, problem))
    throw usage_error("OUT", "the results would take the place of what they are made from", "another folder");
}

}  // namespace

std::vector<fs::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context) {
  const RenderedFrames frames = find_rendered_frames(params.in);
  const Conversion conversion = make_conversion(params, frames);
  const fs::path from = frames.files.front().parent_path();
  make_folder(params.out, from.empty() ? "." : from);
  std::vector<fs::path> written;
  for (const fs::path& file : frames.files) {
    if (context.cancelled) return written;
    const Picture picture = read_panel_picture(frames, file);
    written.push_back(params.out / file.filename());
    if (!std::holds_alternative<Image>(picture)) written.back().replace_extension(".png");
    write_picture(written.back(), apply(conversion.map, picture));
  }
  written.push_back(params.out / "report.json");
  write_report(written.back(), params, frames, conversion.optics);
  return written;
}

}  // namespace lippmann
