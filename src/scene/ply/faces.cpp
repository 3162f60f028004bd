#include "scene/ply/faces.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "scene/ply/columns.hpp"
#include "scene/ply/row.hpp"
#include "scene/polygon.hpp"

namespace lippmann::ply {
namespace {

int corners_column(Columns& columns, const std::string& name, std::string_view plural) {
  for (const std::string_view list : {"vertex_indices", "vertex_index"})
    if (const int column = columns.list(list); column >= 0) return column;
  throw Error(name, fmt::format("its {} have no vertices", plural), "a list vertex_indices");
}

double last_vertex(const Mesh& mesh) { return static_cast<double>(mesh.positions.size()) - 1.0; }

struct FaceColumns {
  int corners = -1, uvs = -1, picture = -1, alpha = -1;
  std::optional<std::array<int, 3>> color;
  bool has_appearance() const { return uvs >= 0 || picture >= 0 || alpha >= 0 || color; }
};

/// Colours of vertices take precedence over those of faces; texture coordinates of faces take precedence over those of
/// vertices.
FaceColumns find_face_columns(const std::string& name, const Element& element, const Mesh& mesh, const Context& context) {
  Columns columns(element);
  FaceColumns found;
  found.corners = corners_column(columns, name, "faces");
  found.uvs = columns.list("texcoord");
  if (found.uvs >= 0 && !mesh.uvs.empty())
    context.warning(fmt::format("{}: the texture coordinates of vertices are left out: faces have their own.", name));
  found.picture = columns.value("texnumber");
  if (mesh.colors.empty()) found.color = columns.color();
  if (mesh.alphas.empty()) found.alpha = columns.alpha();
  columns.warn_about_unread(name, context);
  return found;
}

class FaceReader {
 public:
  FaceReader(const Element& element, const FaceColumns& columns, Body& body, PlyMesh& ply)
      : element_(element), columns_(columns), body_(body), ply_(ply), row_(element) {}

  void read(std::int64_t row) {
    body_.set_place(element_.name, row);
    corners_.clear(), outline_.clear(), uvs_.clear();
    for (std::size_t i = 0; i < element_.properties.size(); ++i) read_property(element_.properties[i], i);
    add_face();
  }

  const Row& row() const { return row_; }

 private:
  void read_property(const Property& property, std::size_t column) {
    const int i = static_cast<int>(column);
    if (i == columns_.corners) {
      const std::uint32_t count = body_.length(property, static_cast<double>(ply_.mesh.positions.size()));
      for (std::uint32_t k = 0; k < count; ++k)
        corners_.push_back(body_.index(property.type, last_vertex(ply_.mesh), "a vertex"));
    } else if (i == columns_.uvs) {
      const std::uint32_t count = body_.length(property);
      for (std::uint32_t k = 0; k < count; ++k) uvs_.push_back(static_cast<float>(body_.bounded(property.type)));
    } else if (property.count_type) {
      body_.skip(property);
    } else {
      row_.set(column, body_.value(property.type));
    }
  }

  void add_face() {
    for (const std::uint32_t corner : corners_) outline_.push_back(ply_.mesh.positions[corner]);
    if (corners_.size() > kMostConcaveCorners && !turns_one_way(outline_))
      throw body_.error(fmt::format("is concave and has {} corners", corners_.size()),
                        fmt::format("at most {}", kMostConcaveCorners));
    if (!uvs_.empty() && uvs_.size() != 2 * corners_.size())
      throw body_.error(fmt::format("has {} corners and {} values texcoord", corners_.size(), uvs_.size()),
                        "two values for each corner, or none");
    const FaceAppearance appearance = columns_.has_appearance() ? face_appearance() : FaceAppearance{};
    for (const Triangle& t : triangulate(outline_)) {
      ply_.mesh.triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
      if (!columns_.has_appearance()) continue;
      ply_.appearances.push_back(appearance);
      for (std::size_t k = 0; k < 3 && !uvs_.empty(); ++k)
        ply_.appearances.back().uvs[k] = {uvs_[2 * t[k]], 1.0f - uvs_[2 * t[k] + 1]};
    }
  }

  FaceAppearance face_appearance() {
    FaceAppearance appearance;
    if (columns_.color) appearance.color = row_.color(*columns_.color);
    if (columns_.alpha >= 0) appearance.alpha = static_cast<float>(row_.share(columns_.alpha));
    const bool has_uvs = columns_.uvs < 0 || !uvs_.empty();
    appearance.picture = !has_uvs ? -1 : columns_.picture >= 0 ? row_.picture(columns_.picture) : 0;
    return appearance;
  }

  const Element& element_;
  const FaceColumns& columns_;
  Body& body_;
  PlyMesh& ply_;
  Row row_;
  std::vector<std::uint32_t> corners_;
  std::vector<Vec3f> outline_;
  std::vector<float> uvs_;
};

/// Reads triangle strips, as in Stanford's scans. A list contains several strips of vertices; -1 ends a strip.
class StripReader {
 public:
  StripReader(Body& body, Mesh& mesh) : body_(body), mesh_(mesh) {}

  void read(const Property& list) {
    const std::uint32_t count = body_.length(list);
    corners_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      const double value = body_.value(list.type);
      if (ends_strip(value))
        corners_.clear();
      else
        extend(body_.checked_index(value, last_vertex(mesh_), "a vertex"));
    }
  }

 private:
  /// Returns whether a value ends a strip. The value is -1 in a signed type, or the same bits in an unsigned type.
  static bool ends_strip(double value) { return value == -1.0 || value == 4294967295.0; }

  /// Every second triangle of a strip has the opposite winding. Triangles with repeated corners only connect strips.
  void extend(std::uint32_t corner) {
    corners_.push_back(corner);
    const std::size_t n = corners_.size();
    if (n < 3) return;
    std::uint32_t a = corners_[n - 3], b = corners_[n - 2];
    if (n % 2 == 0) std::swap(a, b);
    if (a != b && b != corner && a != corner) mesh_.triangles.push_back({a, b, corner});
  }

  Body& body_;
  Mesh& mesh_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

void read_faces(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply) {
  const FaceColumns columns = find_face_columns(name, element, ply.mesh, context);
  ply.own = {columns.uvs >= 0, columns.color.has_value(), columns.alpha >= 0};
  if (columns.has_appearance()) ply.appearances.resize(ply.mesh.triangles.size());
  FaceReader reader(element, columns, body, ply);
  for (std::int64_t row = 0; row < element.count; ++row) reader.read(row);
  reader.row().warn_about_clamped_colors(name, context);
}

void read_strips(const std::string& name, const Element& element, Body& body, const Context& context, PlyMesh& ply) {
  Columns columns(element);
  const int list = corners_column(columns, name, "strips");
  columns.warn_about_unread(name, context);
  StripReader reader(body, ply.mesh);
  for (std::int64_t row = 0; row < element.count; ++row) {
    body.set_place(element.name, row);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (static_cast<int>(i) == list)
        reader.read(element.properties[i]);
      else
        body.skip(element.properties[i]);
    }
  }
}

}  // namespace lippmann::ply
