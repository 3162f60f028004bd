// Based on: B. Kerbl and others, "3D Gaussian Splatting for Real-Time Radiance Field Rendering", 2023, and the files of its
// program. The properties of a splat are:
// - x, y, z: centre,
// - f_dc_0 to 2: spherical harmonics of degree 0,
// - f_rest_*: spherical harmonics of higher degrees; all coefficients of red first, then green, then blue,
// - opacity: a logit,
// - scale_0 to 2: logarithms of the standard deviations,
// - rot_0 to 3: a quaternion (w, x, y, z) of any length,
// - normals, which are unused.
//
// Other programs deviate: nerfstudio writes red, green and blue instead of f_dc. Discs have only scale_0 and scale_1 (B. Huang
// and others, "2D Gaussian Splatting", 2024). Round splats have only scale_0.
#include "scene/ply/splats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "lippmann/core/error.hpp"
#include "scene/ply/columns.hpp"
#include "scene/ply/vertices.hpp"
#include "scene/splats.hpp"

namespace lippmann::ply {
namespace {

bool has_property(const Element& element, std::string_view name) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const Property& property) { return property.name == name && !property.count_type; });
}

struct SplatColumns {
  std::array<int, 3> center{}, color{};
  std::vector<int> scale;
  std::optional<std::array<int, 4>> rotation;
  int opacity = -1;
  bool has_harmonics = true;
  std::vector<int> rest;
};

class SplatReader {
 public:
  SplatReader(const std::string& name, const Header& header, Body& body, const Vec3d& origin, const Context& context)
      : name_(name),
        element_(*vertices_of(header)),
        body_(body),
        origin_(origin),
        is_floats_(header.format == Format::kLittleEndian && std::endian::native == std::endian::little) {
    for (const Property& property : element_.properties) is_floats_ &= property.type == Type::kFloat && !property.count_type;
    find_columns(context);
  }

  Splats read() {
    Splats splats;
    splats.degree = degree_;
    row_.resize(element_.properties.size()), floats_.resize(row_.size());
    const std::size_t count = std::min(static_cast<std::size_t>(element_.count), body_.bytes_left() / row_.size());
    splats.centers.reserve(count), splats.rotations.reserve(count), splats.deviations.reserve(count);
    splats.opacities.reserve(count), splats.harmonics.reserve(count * harmonics_of(degree_));
    for (std::int64_t i = 0; i < element_.count; ++i) {
      body_.set_place(element_.name, i);
      read_row();
      add_row(splats);
    }
    return splats;
  }

 private:
  int required(Columns& columns, const std::string& property) const {
    const int column = columns.value(property);
    if (column < 0) throw Error(name_, fmt::format("its splats have no property \"{}\"", property));
    return column;
  }

  void find_columns(const Context& context) {
    Columns columns(element_);
    const char* axes[] = {"x", "y", "z"};
    for (std::size_t c = 0; c < 3; ++c) columns_.center[c] = required(columns, axes[c]);
    columns_.scale.push_back(required(columns, "scale_0"));
    for (const char* const scale : {"scale_1", "scale_2"})
      if (const int column = columns.value(scale); column >= 0) columns_.scale.push_back(column);
    columns_.rotation = columns.values<4>({{"rot_0", "rot_1", "rot_2", "rot_3"}});
    if (!columns_.rotation && columns_.scale.size() > 1)
      for (int c = 0; c < 4; ++c) required(columns, fmt::format("rot_{}", c));
    columns_.opacity = required(columns, "opacity");
    find_colors(columns);
    columns.values<3>({{"nx", "ny", "nz"}});
    columns.warn_about_unread(name_, context);
  }

  void find_colors(Columns& columns) {
    const auto harmonics = columns.values<3>({{"f_dc_0", "f_dc_1", "f_dc_2"}});
    columns_.has_harmonics = harmonics.has_value();
    const auto color = harmonics ? harmonics : columns.color();
    if (!color) throw Error(name_, "its splats have no colour", "properties f_dc_0 to 2, or red, green and blue");
    columns_.color = *color;
    for (int k = 0; columns_.has_harmonics; ++k) {
      const int column = columns.value(fmt::format("f_rest_{}", k));
      if (column < 0) break;
      columns_.rest.push_back(column);
    }
    while (degree_ < 3 && 3 * (harmonics_of(degree_) - 1) < columns_.rest.size()) ++degree_;
    if (3 * (harmonics_of(degree_) - 1) != columns_.rest.size())
      throw Error(name_, fmt::format("its splats have {} values f_rest", columns_.rest.size()), "0, 9, 24 or 45");
  }

  void read_row() {
    if (is_floats_) {
      body_.floats(floats_);
      std::copy(floats_.begin(), floats_.end(), row_.begin());
      return;
    }
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const Property& property = element_.properties[i];
      if (property.count_type)
        body_.skip(property);
      else
        row_[i] = body_.value(property.type);
    }
  }

  double exact(int column) const { return row_[static_cast<std::size_t>(column)]; }
  float at(int column) const { return static_cast<float>(exact(column)); }
  Vec3f at(const std::array<int, 3>& columns) const { return {at(columns[0]), at(columns[1]), at(columns[2])}; }

  Vec3f deviations() const {
    const std::vector<int>& scale = columns_.scale;
    const float x = std::exp(at(scale[0]));
    if (scale.size() == 1) return Vec3f(x);
    return {x, std::exp(at(scale[1])), scale.size() == 3 ? std::exp(at(scale[2])) : 0.0f};
  }

  /// Returns the coefficient of degree 0. If the file has no harmonics, computes it from red, green and blue.
  Vec3f first_harmonic() const {
    const Vec3f value = at(columns_.color);
    if (columns_.has_harmonics) return value;
    const Type type = element_.properties[static_cast<std::size_t>(columns_.color[0])].type;
    return first_harmonic_of(value / static_cast<float>(full_scale(type)));
  }

  void add_row(Splats& splats) {
    const Vec3d center(exact(columns_.center[0]), exact(columns_.center[1]), exact(columns_.center[2]));
    splats.centers.emplace_back(center - origin_);
    splats.deviations.push_back(deviations());
    const auto r = columns_.rotation;
    splats.rotations.push_back(r ? Quatf(at((*r)[0]), at((*r)[1]), at((*r)[2]), at((*r)[3])) : Quatf(1.0f, 0.0f, 0.0f, 0.0f));
    splats.opacities.push_back(1.0f / (1.0f + std::exp(-at(columns_.opacity))));
    splats.harmonics.push_back(first_harmonic());
    const std::size_t each = columns_.rest.size() / 3;
    for (std::size_t k = 0; k < each; ++k)
      splats.harmonics.emplace_back(at(columns_.rest[k]), at(columns_.rest[each + k]), at(columns_.rest[2 * each + k]));
  }

  const std::string& name_;
  const Element& element_;
  Body& body_;
  Vec3d origin_;
  SplatColumns columns_;
  bool is_floats_;
  int degree_ = 0;
  std::vector<float> floats_;
  std::vector<double> row_;
};

/// Returns the node that turns the file's splats upright. In captures, y points down, unless the file states that z points up.
Node upright_node(bool is_z_up) {
  Node node;
  node.name = "splats";
  node.local.rotation = is_z_up ? z_to_y() : Quatf(0.0f, 1.0f, 0.0f, 0.0f);
  return node;
}

}  // namespace

bool has_splats(const Header& header) {
  const Element* vertices = vertices_of(header);
  return vertices && has_property(*vertices, "scale_0") &&
         (has_property(*vertices, "rot_0") || has_property(*vertices, "opacity"));
}

Scene read_splats(const std::string& name, const Header& header, Body& body, const Vec3d& origin, const Context& context) {
  skip_others(name, header, body, context);
  const Vec3d in_file = header.is_z_up ? Vec3d(origin.x, -origin.z, origin.y) : Vec3d(origin.x, -origin.y, -origin.z);
  Splats splats = SplatReader(name, header, body, in_file, context).read();
  if (const std::size_t dropped = drop_unsound(splats); dropped > 0)
    context.warning(fmt::format("{}: {} splats are left out: they have no size, no rotation or values that are not finite.",
                                name, dropped));
  if (splats.centers.empty()) throw Error(name, "has no splats to show");
  sort_by_place(splats);
  Scene scene;
  scene.kind = SceneKind::kSplats;
  scene.origin = origin;
  scene.nodes.push_back(upright_node(header.is_z_up));
  scene.materials.push_back(splat_material());
  scene.shapes.emplace_back(std::move(splats));
  scene.instances.push_back({"splats", 0, 0, 0});
  return scene;
}

}  // namespace lippmann::ply
