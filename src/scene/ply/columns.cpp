#include "scene/ply/columns.hpp"

#include <fmt/format.h>

#include "core/printable.hpp"

namespace lippmann::ply {

std::optional<std::array<int, 3>> Columns::color() {
  return values<3>({{"red", "green", "blue"}, {"r", "g", "b"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}});
}

int Columns::alpha() {
  for (const std::string_view name : {"alpha", "a", "diffuse_alpha"})
    if (const int column = value(name); column >= 0) return column;
  return -1;
}

void Columns::warn_about_unread(const std::string& file, const Context& context) const {
  LeftOut unread;
  for (std::size_t i = 0; i < read_.size(); ++i)
    if (!read_[i]) unread.add(element_.properties[i].name, fmt::format("{}: element {}", file, shown(element_.name)));
  unread.warn(context, "property", "properties");
}

int Columns::find(std::string_view name, bool is_list) const {
  for (std::size_t i = 0; i < element_.properties.size(); ++i) {
    const Property& property = element_.properties[i];
    if (property.name == name && property.count_type.has_value() == is_list) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace lippmann::ply
