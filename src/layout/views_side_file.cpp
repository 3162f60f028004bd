#include "layout/views_side_file.hpp"

#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"

namespace lippmann {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

fs::path views_side_path(const fs::path& folder) { return folder / "views.json"; }

}  // namespace

std::optional<double> parse_pixel_aspect(const std::string& text, const std::string& where) {
  const Json json = json_from_text(text);
  if (json.is_discarded()) throw json_error(text, where);
  if (!json.is_object() || !json.contains("views")) return std::nullopt;
  return JsonFields(json["views"], where, "views").number("pixel_aspect", {1e-3, 1e3});
}

std::optional<double> read_pixel_aspect(const fs::path& folder) {
  constexpr std::uintmax_t kMaxBytes = 1 << 20;
  if (!has_views_side_file(folder)) return std::nullopt;
  const fs::path path = views_side_path(folder);
  return parse_pixel_aspect(read_recorded_text(path, kMaxBytes, "the side file of a folder of views"), path.string());
}

fs::path write_pixel_aspect(const fs::path& folder, double pixel_aspect) {
  const std::string text = json_to_text(Json{{"views", {{"pixel_aspect", pixel_aspect}}}}) + '\n';
  write_file_atomically(views_side_path(folder), std::as_bytes(std::span(text)));
  return views_side_path(folder);
}

bool has_views_side_file(const fs::path& folder) { return is_regular_file_there(views_side_path(folder)); }

}  // namespace lippmann
