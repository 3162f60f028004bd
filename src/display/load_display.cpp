#include "lippmann/display/load_display.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "core/file_content.hpp"
#include "core/printable.hpp"
#include "core/regular_file.hpp"
#include "core/suggest.hpp"
#include "display/document.hpp"
#include "display/presets.hpp"
#include "display/read_display.hpp"
#include "display/sheet_line.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view kMaker = "looking-glass-";

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

const PresetFile* find_preset(std::string_view name) {
  for (const PresetFile& preset : preset_files())
    if (preset.name == name || (preset.name.starts_with(kMaker) && preset.name.substr(kMaker.size()) == name)) return &preset;
  return nullptr;
}

Error unknown_preset(const std::string& where, const std::string& name) {
  std::vector<std::string_view> names;
  for (const PresetFile& preset : preset_files()) {
    names.push_back(preset.name);
    if (preset.name.starts_with(kMaker)) names.push_back(preset.name.substr(kMaker.size()));
  }
  return Error(where, "there is no display " + shown(name) + did_you_mean(name, names),
               "a name that 'lippmann displays' lists, or a file: .toml, or .json for a calibration", ErrorKind::kUsage);
}

Display named_preset(const PresetFile& preset) {
  Display display = display_from_toml(preset.text, std::string(preset.name));
  display.name = std::string(preset.name);
  return display;
}

std::optional<Display> preset_of_serial(const std::string& serial) {
  std::optional<Display> best;
  std::size_t length = 0;
  for (const Display& display : display_presets())
    for (const std::string& prefix : display.serials)
      if (prefix.size() > length && serial.starts_with(prefix)) best = display, length = prefix.size();
  return best;
}

/// Returns a display for an unknown device, with the most common quilt for a portrait or landscape panel.
Display unknown_device(Vec2i pixels) {
  Display display;
  display.pixels = pixels;
  display.description = "a slanted panel of no known kind";
  display.quilt = DisplayQuilt{8, 6, 4096, 4096, static_cast<double>(pixels.x) / pixels.y};
  if (pixels.x > pixels.y) display.quilt->columns = 5, display.quilt->rows = 9;
  return display;
}

void require(const Json& json, const char* key, const std::string& where, const std::string& serial) {
  if (!json.contains(key))
    throw Error(where + ": " + key, "is missing, and no known device has the serial number " + shown(serial),
                "screenW, screenH and DPI");
}

std::string text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string read_text(const fs::path& path) {
  return read_file_text(path, kMaxDocumentBytes, "a display's .toml or calibration .json");
}

Display load_file(const fs::path& path) {
  const std::string text = read_text(path);
  if (const auto stand_in = stand_in_for_file(std::as_bytes(std::span(text))))
    throw Error(path.string(), "is " + stand_in->what, stand_in->advice);
  Display display =
      path.extension() == ".toml" ? display_from_toml(text, path.string()) : display_from_calibration(text, path.string());
  display.name = path.stem().string();
  return display;
}

}  // namespace

Display display_from_toml(std::string_view text, const std::string& where) {
  Json json = parse_toml(text, where);
  if (const std::string base = text_of(json, "base"); !base.empty()) {
    const PresetFile* preset = find_preset(lower(base));
    if (!preset) throw unknown_preset(where + ": base", base);
    Json whole = parse_toml(preset->text, std::string(preset->name));
    whole.merge_patch(json);
    json = std::move(whole);
  }
  return display_from_tables(json, where);
}

Display display_from_calibration(std::string_view text, const std::string& where) {
  Json json = parse_json(text, where);
  for (const char* key : {"calibration", "config"})
    if (!json.contains("pitch") && json.contains(key) && json[key].is_object()) json = Json(json[key]);
  const std::string serial = printable(text_of(json, "serial"));
  std::optional<Display> base = preset_of_serial(serial);
  if (!base) {
    for (const char* key : {"screenW", "screenH", "DPI"}) require(json, key, where, serial);
    base = unknown_device({1, 1});
    const Display sized = display_from_visual(json, where, *base);
    base = unknown_device(sized.pixels);
  }
  Display display = display_from_visual(json, where, *base);
  display.description += serial.empty() ? ", calibrated" : ", calibrated: " + serial;
  display.serials = serial.empty() ? std::vector<std::string>() : std::vector{serial};
  return display;
}

Display load_display(const std::string& preset_or_path) {
  const std::string ending = lower(fs::path(preset_or_path).extension().string());
  if (ending == ".toml" || ending == ".json") return load_file(preset_or_path);
  if (const PresetFile* preset = find_preset(lower(preset_or_path))) return named_preset(*preset);
  if (is_sheet_line(preset_or_path)) {
    Display display = display_from_line(preset_or_path);
    check_display(display, "display");
    return display;
  }
  throw unknown_preset("display", preset_or_path);
}

bool is_display_file(const std::string& display) { return !find_preset(lower(display)) && !is_sheet_line(display); }

std::vector<Display> display_presets() {
  std::vector<Display> displays;
  for (const PresetFile& preset : preset_files()) displays.push_back(named_preset(preset));
  return displays;
}

}  // namespace lippmann
