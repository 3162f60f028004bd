#include "scene/ply/row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/printable.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::ply {

void Row::read(Body& body) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Property& property = element_.properties[i];
    if (property.count_type)
      body.skip(property);
    else
      values_[i] = body.value(property.type);
  }
}

double Row::position(int column, const Body& body) const {
  const double value = exact(column);
  if (!is_usable(value))
    throw body.error(
        fmt::format("property {} has the value {}", shown(element_.properties[static_cast<std::size_t>(column)].name), value),
        "at most 1e18");
  return value;
}

double Row::share(int column) {
  const auto i = static_cast<std::size_t>(column);
  const double scale = full_scale(element_.properties[i].type), value = values_[i] / scale;
  if (!(0.0 <= value && value <= 1.0)) ++cut_, cut_scale_ = scale;
  return value >= 0.0 ? std::min(value, 1.0) : 0.0;
}

Vec3f Row::color(const std::array<int, 3>& columns) {
  Vec3f linear;
  for (int c = 0; c < 3; ++c) linear[c] = static_cast<float>(linear_from_srgb(share(columns[static_cast<std::size_t>(c)])));
  return linear;
}

int Row::picture(int column) const {
  const double number = values_[static_cast<std::size_t>(column)];
  return number >= 0.0 && number < 1e6 && number == std::floor(number) ? static_cast<int>(number) : -1;
}

void Row::warn_about_clamped_colors(const std::string& file, const Context& context) const {
  if (cut_ > 0) context.warning(fmt::format("{}: {} colour values are clamped to 0 to {}.", file, cut_, cut_scale_));
}

}  // namespace lippmann::ply
