// Based on: B. Kerbl and others, "3D Gaussian Splatting for Real-Time Radiance Field Rendering", 2023: the files that its
// program writes. All properties are floats: x, y, z; f_dc_0 to 2 and f_rest_*, the spherical harmonics of degree 0 and of the
// others, these channel by channel; opacity before the logistic function; scale_0 to 2, logarithms of standard deviations;
// rot_0 to 3, a quaternion (w, x, y, z) of any length. Normals are there and mean nothing.
#include "scene/ply/splats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "lippmann/core/error.hpp"
#include "scene/splats.hpp"

namespace lippmann::ply {
namespace {

static_assert(std::endian::native == std::endian::little, "rows are copied as they are");

const Element* vertices_of(const Header& header) {
  const auto found = std::find_if(header.elements.begin(), header.elements.end(),
                                  [](const Element& element) { return element.name == "vertex"; });
  return found == header.elements.end() ? nullptr : &*found;
}

/// -1: there is none.
int column_of(const Element& element, const std::string& property) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == property) return static_cast<int>(i);
  return -1;
}

/// Where the values of a splat stand in its row.
struct Columns {
  int center[3], scale[3], rotation[4], opacity, first_harmonic[3];
  std::vector<int> rest;  ///< channel by channel
};

class SplatReader {
 public:
  SplatReader(const std::string& name, const Header& header, std::string_view body)
      : name_(name), element_(*vertices_of(header)), body_(body) {
    if (header.format != Format::kLittleEndian) throw Error(name_, "has splats as text or big-endian", "binary_little_endian");
    for (const Property& property : element_.properties)
      if (property.type != Type::kFloat || property.count_type)
        throw Error(name_, fmt::format("the splats' property {} is no float", shown_name(property.name)), "float");
    if (&element_ != &header.elements.front())
      throw Error(name_, "something stands before its splats", "the element vertex first");
    find_columns();
    check_size();
  }

  Splats read() {
    const auto count = static_cast<std::size_t>(element_.count);
    Splats splats;
    splats.degree = degree_;
    splats.centers.reserve(count), splats.rotations.reserve(count), splats.deviations.reserve(count);
    splats.opacities.reserve(count), splats.harmonics.reserve(count * harmonics_of(degree_));
    row_.resize(element_.properties.size());
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(row_.data(), body_.data() + i * row_bytes(), row_bytes());
      add_row(splats);
    }
    return splats;
  }

 private:
  static std::string shown_name(const std::string& property) { return fmt::format("\"{}\"", property); }

  int required(const std::string& property) const {
    const int column = column_of(element_, property);
    if (column < 0) throw Error(name_, fmt::format("its splats have no property {}", shown_name(property)));
    return column;
  }

  void find_columns() {
    const char* axes[] = {"x", "y", "z"};
    for (int c = 0; c < 3; ++c) {
      columns_.center[c] = required(axes[c]);
      columns_.scale[c] = required(fmt::format("scale_{}", c));
      columns_.first_harmonic[c] = required(fmt::format("f_dc_{}", c));
    }
    for (int c = 0; c < 4; ++c) columns_.rotation[c] = required(fmt::format("rot_{}", c));
    columns_.opacity = required("opacity");
    for (int k = 0; column_of(element_, fmt::format("f_rest_{}", k)) >= 0; ++k)
      columns_.rest.push_back(column_of(element_, fmt::format("f_rest_{}", k)));
    while (degree_ < 3 && 3 * (harmonics_of(degree_) - 1) < columns_.rest.size()) ++degree_;
    if (3 * (harmonics_of(degree_) - 1) != columns_.rest.size())
      throw Error(name_, fmt::format("its splats have {} values f_rest", columns_.rest.size()), "0, 9, 24 or 45");
  }

  std::size_t row_bytes() const { return sizeof(float) * element_.properties.size(); }

  void check_size() const {
    const std::size_t rows = body_.size() / row_bytes();
    if (rows < static_cast<std::size_t>(element_.count))
      throw Error(name_, fmt::format("the file ends after {} of {} splats", rows, element_.count));
  }

  float at(int column) const { return row_[static_cast<std::size_t>(column)]; }
  Vec3f at(const int (&columns)[3]) const { return {at(columns[0]), at(columns[1]), at(columns[2])}; }

  void add_row(Splats& splats) {
    splats.centers.push_back(at(columns_.center));
    splats.deviations.push_back(glm::exp(at(columns_.scale)));
    const auto& r = columns_.rotation;
    splats.rotations.emplace_back(at(r[0]), at(r[1]), at(r[2]), at(r[3]));
    splats.opacities.push_back(1.0f / (1.0f + std::exp(-at(columns_.opacity))));
    splats.harmonics.push_back(at(columns_.first_harmonic));
    const std::size_t each = columns_.rest.size() / 3;
    for (std::size_t k = 0; k < each; ++k)
      splats.harmonics.emplace_back(at(columns_.rest[k]), at(columns_.rest[each + k]), at(columns_.rest[2 * each + k]));
  }

  const std::string& name_;
  const Element& element_;
  std::string_view body_;
  Columns columns_{};
  int degree_ = 0;
  std::vector<float> row_;
};

/// Captures have the axes of their photographs: y downwards.
Node upright_node() {
  Node node;
  node.name = "splats";
  node.local.rotation = Quatf(0.0f, 1.0f, 0.0f, 0.0f);
  return node;
}

}  // namespace

bool has_splats(const Header& header) {
  const Element* vertices = vertices_of(header);
  return vertices && column_of(*vertices, "scale_0") >= 0 && column_of(*vertices, "rot_0") >= 0 &&
         column_of(*vertices, "opacity") >= 0 && column_of(*vertices, "f_dc_0") >= 0;
}

Scene read_splats(const std::string& name, const Header& header, std::string_view body, const Context& context) {
  Splats splats = SplatReader(name, header, body).read();
  if (const std::size_t dropped = drop_unsound(splats); dropped > 0)
    context.warning(fmt::format("{}: {} splats are left out: they have no size, no rotation or values that are not finite.",
                                name, dropped));
  if (splats.centers.empty()) throw Error(name, "has no splats to show");
  sort_by_place(splats);
  Scene scene;
  scene.nodes.push_back(upright_node());
  scene.materials.push_back(splat_material());
  scene.shapes.emplace_back(std::move(splats));
  scene.instances.push_back({"splats", 0, 0, 0});
  return scene;
}

}  // namespace lippmann::ply
