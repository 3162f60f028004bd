#include "job/job_file.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/atomic_file.hpp"
#include "core/file_content.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "job/params_table.hpp"
#include "job/removed_params.hpp"
#include "job/scene_light.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool is_relative_path(const ParamInfo& info, const std::string& value) {
  return info.is_path && !value.empty() && fs::path(value).is_relative() &&
         !(info.name == "scene" && is_builtin_scene(value)) && !(info.name == "display" && !is_display_file(value)) &&
         !(info.name == "environment" && !environment_is_file(value));
}

/// Normalises the path and removes a trailing slash. Returns "." for an empty path.
std::string tidy(const fs::path& path) {
  std::string text = path.lexically_normal().string();
  while (text.size() > 1 && text.back() == '/') text.pop_back();
  return text.empty() ? "." : text;
}

constexpr std::uintmax_t kMaxBytesOfJob = std::uintmax_t{1} << 20;

// ---- Reading --------------------------------------------------------------------------------------------------------

/// Converts a TOML value to the text that a flag would take. `where`: location of the key, for messages.
std::string value_text(const toml::node& node, const std::string& where) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return fmt::format("{}", whole->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  throw usage_error(where, "the value is of the wrong type", "a text, a number, true or false");
}

std::vector<std::string> value_texts(const ParamInfo& info, const toml::node& node, const std::string& where) {
  const toml::array* array = node.as_array();
  if (!array) return {value_text(node, where)};
  if (info.kind != ParamKind::kList) throw usage_error(where, "is a list; expected one value", std::string(info.type));
  std::vector<std::string> texts;
  for (const toml::node& element : *array) texts.push_back(value_text(element, where));
  return texts;
}

toml::table parse(const fs::path& file) {
  const std::string text = read_file_text(file, kMaxBytesOfJob, "a job in TOML");
  if (const auto stand_in = stand_in_for_file(std::as_bytes(std::span(text))))
    throw Error(file.string(), "is " + stand_in->what, stand_in->advice);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}:{}", file.string(), error.source().begin.line), std::string(error.description()),
                "a job in TOML: key = value");
  }
}

// ---- Writing --------------------------------------------------------------------------------------------------------

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + '"';
}

std::string toml_value(const ParamInfo& info, const std::vector<std::string>& values) {
  if (info.kind == ParamKind::kNumber || info.kind == ParamKind::kFlag) return values.front();
  if (info.kind == ParamKind::kText) return quoted(values.front());
  std::vector<std::string> elements;
  for (const std::string& value : values) elements.push_back(quoted(value));
  return fmt::format("[{}]", fmt::join(elements, ", "));
}

/// Converts a path relative to the working folder to one relative to `folder`. An empty `folder` is the working folder.
std::string path_from(const fs::path& folder, const std::string& path) {
  const fs::path here = fs::current_path();
  return tidy((here / path).lexically_normal().lexically_relative((here / folder / "").lexically_normal()));
}

bool lies_in(const fs::path& folder, const std::string& path) {
  const std::string from = path_from(folder, path);
  return from != ".." && !from.starts_with("../");
}

/// Paths inside the render's output folder are stored relative to it, so that a copied folder renders into the copy.
bool is_own_file(const ParamInfo& info, const std::string& value, const RenderParams& params, const fs::path& folder) {
  const bool is_own_folder = !params.output.folder.empty() && path_from(folder, params.output.folder) == ".";
  return is_own_folder && (info.name == "output" || info.name == "video") && !value.empty() && lies_in(folder, value);
}

/// Sets a parameter through its opposite: full-depth = true sets fit-depth = false, and vice versa.
void set_opposite(const ParamInfo& info, const toml::table& job, const std::string& value, const std::string& place,
                  RenderParams& params) {
  const std::string where = fmt::format("{}: {}", place, info.opposite);
  if (job.contains(info.name)) throw usage_error(where, fmt::format("is set by {} already", info.name), "one of the two");
  if (value != "true" && value != "false") throw usage_error(where, fmt::format("'{}'", value), "true or false");
  info.set(params, {value == "true" ? "false" : "true"}, where);
}

bool is_as_recorded(const fs::path& file) try {
  if (is_regular_file_there(file)) require_as_recorded(file);
  return true;
} catch (const Error&) {
  return false;
}

}  // namespace

void read_job(const fs::path& file, RenderParams& params) try {
  const toml::table table = parse(file);
  for (const auto& [key, node] : table) {
    const std::string place = fmt::format("{}:{}", file.string(), key.source().begin.line);
    if (const ParamInfo* info = find_opposite(key.str())) {
      set_opposite(*info, table, value_text(node, place), place, params);
      continue;
    }
    if (const auto removed = removal_of(key.str(), "", fmt::format("{}: {}", place, key.str()))) throw *removed;
    const ParamInfo* info = find_param(key.str());
    if (!info) throw usage_error(place, fmt::format("there is no key '{}'{}", key.str(), did_you_mean(key.str())));
    const std::string where = fmt::format("{}: {}", place, info->name);
    std::vector<std::string> values = value_texts(*info, node, where);
    for (std::string& value : values)
      if (is_relative_path(*info, value)) value = tidy(file.parent_path() / value);
    info->set(params, values, where);
  }
} catch (const Error& error) {
  if (is_as_recorded(file)) throw;
  throw Error(
      file.string(),
      fmt::format("is damaged or was edited: it differs from the file that its render wrote, and cannot be read ({}: {})",
                  error.where(), error.problem()),
      fmt::format("the file as it was; the first command with `-o {} --resume` writes it again",
                  shell_word(file.parent_path().empty() ? "." : file.parent_path().string())));
}

std::string job_text(const RenderParams& params, const fs::path& folder) {
  std::string text = std::string("# A job of lippmann ") + version() + ". It renders again with: lippmann render FILE\n";
  std::string_view group;
  for (const ParamInfo& info : params_table()) {
    std::vector<std::string> values = info.get(params);
    if (values.empty()) continue;
    for (std::string& value : values)
      if (is_relative_path(info, value) || is_own_file(info, value, params, folder)) value = path_from(folder, value);
    if (group != info.group) text += fmt::format("\n# {}\n", info.group);
    group = info.group;
    text += fmt::format("{} = {}\n", info.name, toml_value(info, values));
  }
  return text;
}

void write_job(const fs::path& file, const RenderParams& params) {
  const std::string text = job_text(params, file.parent_path());
  write_file_atomically(file, std::as_bytes(std::span(text)));
}

}  // namespace lippmann
