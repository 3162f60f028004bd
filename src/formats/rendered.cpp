#include "formats/rendered.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string_view>
#include <system_error>

#include "core/file_content.hpp"
#include "core/folder_entries.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/frame_names.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"
#include "optics/optics_json.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMaxReportBytes = std::uintmax_t{256} << 20;  // room for 400,000 frames of about 600 bytes each

using LayerChannels = std::span<const std::string>;

bool has_channels(const fs::path& picture, LayerChannels channels) {
  const std::vector<std::string> names = channel_names(picture);
  return std::all_of(channels.begin(), channels.end(),
                     [&](const std::string& channel) { return std::find(names.begin(), names.end(), channel) != names.end(); });
}

/// Reads a layer from the picture itself if it is an EXR file with this layer, otherwise from the file of layers beside
/// it.
std::optional<Image> rendered_layer(const fs::path& picture, LayerChannels channels) {
  if (picture.extension() == ".exr" && has_channels(picture, channels)) return read_channels(picture, channels);
  static const TextPattern numbered("(?:frame|view)_([0-9]+).*");
  const auto found = numbered.match(picture.filename().string());
  if (!found) return std::nullopt;
  const fs::path layers = picture.parent_path() / ("aov_" + found->groups[1] + ".exr");
  if (!is_regular_file_there(layers) || !has_channels(layers, channels)) return std::nullopt;
  return read_channels(layers, channels);
}

Json read_report(const fs::path& report) {
  const std::string text =
      read_recorded_text(report, kMaxReportBytes, "the report.json that `lippmann render` writes beside its pictures");
  if (const auto stand_in = stand_in_for_file(std::as_bytes(std::span(text))))
    throw Error(report.string(), "is " + stand_in->what, stand_in->advice);
  Json json = json_from_text(text);
  if (!json.is_object()) throw Error(report.string(), "is not a JSON object", "the report.json that `lippmann render` writes");
  return json;
}

/// Returns the depth scale that a report states, or 1 if the scale is missing or implausible.
float depth_scale_of(const Json& report) {
  const auto depth = report.find("depth");
  if (depth == report.end() || !depth->is_object()) return 1.0f;
  const auto scale = depth->find("scale");
  const double value = scale != depth->end() && scale->is_number() ? scale->get<double>() : 1.0;
  return value > 0.0 && value <= 1.0 ? static_cast<float>(value) : 1.0f;
}

bool lists(const Json& json, const char* text) {
  return json.is_array() && std::find(json.begin(), json.end(), Json(text)) != json.end();
}

FrameFacts frame_facts(const Json& frame) {
  constexpr std::array<std::string_view, 3> kKinds{"full", "key", "in-between"};
  FrameFacts facts;
  if (const auto kind = frame.find("kind"); kind != frame.end() && kind->is_string()) {
    for (const std::string_view known : kKinds)
      if (*kind == known) facts.kind = known;
    if (*kind == "shared") facts.kind = "full";  // reports of earlier versions use this word
  }
  if (const auto psnr = frame.find("estimated_psnr_db"); psnr != frame.end() && psnr->is_number())
    if (const double value = psnr->get<double>(); std::isfinite(value)) facts.psnr_db = value;
  return facts;
}

/// Returns the facts of a report's frames by frame number. Skips malformed entries.
std::map<int, FrameFacts> frames_of(const Json& report) {
  std::map<int, FrameFacts> frames;
  const auto list = report.find("frames");
  if (list == report.end() || !list->is_array()) return frames;
  for (const Json& frame : *list) {
    if (!frame.is_object()) continue;
    const auto number = frame.find("frame");
    if (number != frame.end() && number->is_number_integer() && number->get<std::int64_t>() >= 0 &&
        number->get<std::int64_t>() < (std::int64_t{1} << 30))
      frames[number->get<int>()] = frame_facts(frame);
  }
  return frames;
}

Rendering rendering_from(const Json& json, const fs::path& report) {
  Rendering rendering{optics_from_json(json["optics"], report.string())};
  const Json settings = json.value("settings", Json::object());
  if (settings.contains("layout") && settings["layout"].is_string()) rendering.layout = settings["layout"];
  if (settings.contains("to") && settings["to"].is_string()) rendering.layout = settings["to"];
  if (settings.contains("mirror") && settings["mirror"].is_boolean()) rendering.mirrored = settings["mirror"];
  rendering.has_depth_layer = !settings.contains("aov") || lists(settings["aov"], "depth");
  rendering.has_provenance = settings.contains("aov") && lists(settings["aov"], "provenance");
  rendering.frames_per_second = frame_rate_of(json);
  rendering.depth_scale = depth_scale_of(json);
  rendering.frames = frames_of(json);
  return rendering;
}

/// Appends to `names` the files in `folder` / `below` that are report.json or files of frames, but not in `recorded`.
void add_unrecorded(const fs::path& folder, const fs::path& below, const std::set<std::string>& recorded,
                    std::vector<std::string>& names) {
  for (const fs::directory_entry& entry : entries_of(folder / below)) {
    const std::string name = (below / entry.path().filename()).string();
    std::error_code ignored;
    if (entry.is_directory(ignored) && below.empty() && name.starts_with("frame_"))
      add_unrecorded(folder, name, recorded, names);
    else if ((frame_of_file(name) || name == "report.json") && !recorded.contains(name))
      names.push_back(name);
  }
}

/// Warns about files that the journal of a render does not list. Considers only `in` and the files in `in`.
void warn_about_unrecorded_files(const fs::path& folder, const fs::path& in, const Context& context) {
  std::vector<std::string> names;
  add_unrecorded(folder, {}, recorded_names(folder), names);
  std::erase_if(names, [&](const std::string& name) {
    const fs::path file = folder / name;
    return file != in && file.parent_path() != in && folder != in;
  });
  if (names.empty()) return;
  const bool is_one = names.size() == 1;
  context.warning(
      fmt::format("{} has {} that the journal of its render (.lippmann) does not list, so {} not checked for damage: {}{}",
                  folder.string(), is_one ? "a file" : fmt::format("{} files", names.size()), is_one ? "it is" : "they are",
                  names.front(), is_one ? "" : ", ..."));
}

}  // namespace

std::optional<double> frame_rate_of(const Json& report) {
  const auto number = [](const Json& json, const char* key) {
    const auto found = json.find(key);
    const double value = found != json.end() && found->is_number() ? found->get<double>() : 0.0;
    return value > 0.0 && value <= 1000.0 ? std::optional(value) : std::nullopt;
  };
  if (!report.is_object()) return std::nullopt;
  if (const auto rate = number(report, "frames_per_second")) return rate;
  const auto settings = report.find("settings");
  return settings != report.end() && settings->is_object() ? number(*settings, "fps") : std::nullopt;
}

Rendering read_rendering(const fs::path& report) {
  const Json json = read_report(report);
  if (!json.contains("optics"))
    throw Error(report.string(), "does not state the optics of the pictures", "an object \"optics\"");
  return rendering_from(json, report);
}

std::optional<Rendering> readable_rendering(const fs::path& report) try {
  return read_rendering(report);
} catch (const Error&) {
  return std::nullopt;
}

void warn_about_unchecked_files(const fs::path& in, const Context& context) {
  const fs::path whole = fs::absolute(in / "").lexically_normal().parent_path(), folder = whole.parent_path();
  for (const fs::path& of_render : {whole, folder, folder.parent_path()}) {
    if (has_journal(of_render)) return warn_about_unrecorded_files(of_render, whole, context);
    std::error_code ignored;
    const fs::path report = of_render / "report.json";
    if (!fs::is_regular_file(report, ignored)) continue;
    if (read_report(report).contains("runs"))  // reports of converted pictures have no "runs"
      context.warning(fmt::format("{} has no journal of its render (.lippmann), so its files are not checked for damage",
                                  of_render.string()));
    return;
  }
}

std::optional<Rendering> rendering_of(const fs::path& picture) {
  const fs::path folder = picture.parent_path();
  for (const fs::path& report : {picture / "report.json", folder / "report.json", folder.parent_path() / "report.json"}) {
    if (!is_regular_file_there(report)) continue;
    const Json json = read_report(report);
    if (!json.contains("optics")) return std::nullopt;
    return rendering_from(json, report);
  }
  return std::nullopt;
}

std::optional<Image> rendered_depth(const fs::path& picture) {
  static const std::array<std::string, 1> depth{"Z"};
  return rendered_layer(picture, depth);
}

std::optional<Image> rendered_motion(const fs::path& picture) {
  static const std::array<std::string, 2> motion{"motion.X", "motion.Y"};
  return rendered_layer(picture, motion);
}

std::optional<Image> rendered_provenance(const fs::path& picture) {
  static const std::array<std::string, 1> provenance{"provenance"};
  return rendered_layer(picture, provenance);
}

}  // namespace lippmann
