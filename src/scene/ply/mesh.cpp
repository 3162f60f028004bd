#include "scene/ply/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "core/printable.hpp"
#include "lippmann/image/encode.hpp"
#include "scene/directions.hpp"
#include "scene/ply/columns.hpp"
#include "scene/ply/split_faces.hpp"
#include "scene/polygon.hpp"
#include "scene/wind_by_normals.hpp"

namespace lippmann::ply {
namespace {

constexpr const char* kArePacked = "its splats are packed, as PlayCanvas and SuperSplat write .compressed.ply";
constexpr const char* kUnpacked =
    "a .ply of plain splats, which splat-transform IN OUT.ply makes of it (npm's @playcanvas/splat-transform)";

using ColorColumns = std::optional<std::array<int, 3>>;

/// Where the values of a face stand; -1: it has none.
struct FaceColumns {
  int corners = -1, uvs = -1, texture = -1, alpha = -1;
  ColorColumns color;
  bool has_look() const { return uvs >= 0 || texture >= 0 || alpha >= 0 || color; }
};

/// A mesh as the file has it: attributes of vertices, and of triangles where faces have some.
struct PlyMesh {
  Mesh mesh;
  std::vector<FaceLook> looks;      ///< by triangle; empty: faces have no attributes
  std::vector<int> vertex_texture;  ///< by vertex; empty: not given
  FaceAttributes own;
};

class MeshReader {
 public:
  MeshReader(const std::string& name, const Header& header, Body& body, const Context& context)
      : name_(name), header_(header), body_(body), context_(context) {}

  PlyMesh read() {
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue;  // rows of nothing
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        skip(element);
    }
    if (mesh_.triangles.empty())
      throw Error(name_, fmt::format("has {} vertices and no faces", mesh_.positions.size()),
                  "a mesh, or splats (vertices with scale_0, rot_0, opacity); points are not shown");
    const auto is_zero = [](Vec3f n) { return n == Vec3f(0.0f); };
    if (std::any_of(mesh_.normals.begin(), mesh_.normals.end(), is_zero)) mesh_.normals.clear();
    for (Vec3f& normal : mesh_.normals) normal = direction_of(normal);
    if (cut_colors_ > 0)
      context_.warning(
          fmt::format("{}: {} values of colours are cut: they are not between 0 and {}.", name_, cut_colors_, color_scale_));
    if (!result_.looks.empty()) result_.looks.resize(mesh_.triangles.size());  // strips have no look
    return std::move(result_);
  }

 private:
  /// Single values of a row to row_; lists are passed over.
  void read_row(const Element& element, std::int64_t row) {
    body_.set_place(element.name, row);
    row_.resize(element.properties.size());
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (property.count_type)
        body_.pass_over(property);
      else
        row_[i] = body_.bounded(property.type);
    }
  }

  float at(int column) const { return static_cast<float>(row_[static_cast<std::size_t>(column)]); }

  /// A colour's share, encoded as the file has it.
  double share(const Element& element, int column) {
    const auto i = static_cast<std::size_t>(column);
    const double value = row_[i] / full_scale(element.properties[i].type);
    if (!(0.0 <= value && value <= 1.0)) ++cut_colors_, color_scale_ = full_scale(element.properties[i].type);
    return std::clamp(value, 0.0, 1.0);
  }

  Vec3f color(const Element& element, const std::array<int, 3>& columns) {
    const auto linear = [&](int c) { return static_cast<float>(linear_from_srgb(share(element, c))); };
    const float red = linear(columns[0]), green = linear(columns[1]), blue = linear(columns[2]);
    return {red, green, blue};
  }

  void read_vertices(const Element& element) {
    if (!mesh_.positions.empty()) throw Error(name_, "has two lists of vertices", "one element \"vertex\"");
    Columns columns(element);
    const auto xyz = columns.values<3>({{"x", "y", "z"}});
    if (columns.value("packed_position") >= 0) throw Error(name_, kArePacked, kUnpacked);
    if (!xyz) throw Error(name_, "its vertices have no position", "properties x, y and z");
    const auto normal = columns.values<3>({{"nx", "ny", "nz"}});
    const auto uv = columns.values<2>({{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}});
    const ColorColumns rgb = columns.color();
    const int alpha = columns.alpha(), texture = columns.value("texnumber");
    columns.warn_of_unread(name_, context_);
    for (std::int64_t row = 0; row < element.count; ++row) {
      read_row(element, row);
      mesh_.positions.emplace_back(at((*xyz)[0]), at((*xyz)[1]), at((*xyz)[2]));
      if (normal) mesh_.normals.emplace_back(at((*normal)[0]), at((*normal)[1]), at((*normal)[2]));
      if (uv) mesh_.uvs.emplace_back(at((*uv)[0]), 1.0f - at((*uv)[1]));
      if (rgb) mesh_.colors.push_back(color(element, *rgb));
      if (alpha >= 0) mesh_.alphas.push_back(static_cast<float>(share(element, alpha)));
      if (texture >= 0) result_.vertex_texture.push_back(texture_number(texture));
    }
  }

  /// -1 for what is no number of a picture.
  int texture_number(int column) const {
    const double number = row_[static_cast<std::size_t>(column)];
    return number >= 0.0 && number < 1e6 && number == std::floor(number) ? static_cast<int>(number) : -1;
  }

  std::uint32_t read_vertex(Type type) {
    return body_.index(type, static_cast<double>(mesh_.positions.size()) - 1.0, "a vertex");
  }

  int corners_column(Columns& columns, std::string_view plural) const {
    for (const std::string_view name : {"vertex_indices", "vertex_index"})
      if (const int list = columns.list(name); list >= 0) return list;
    throw Error(name_, fmt::format("its {} have no vertices", plural), "a list vertex_indices");
  }

  /// Strips of triangles, as Stanford's scans have them: a list of vertices in which -1 ends a strip.
  void read_strips(const Element& element) {
    Columns columns(element);
    const int list = corners_column(columns, "strips");
    columns.warn_of_unread(name_, context_);
    for (std::int64_t row = 0; row < element.count; ++row) {
      body_.set_place(element.name, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (static_cast<int>(i) == list)
          read_strip_list(element.properties[i]);
        else
          body_.pass_over(element.properties[i]);
      }
    }
  }

  /// A value that ends one strip and begins the next: -1, in whatever type.
  static bool ends_strip(double value) { return value == -1.0 || value == 4294967295.0; }

  void read_strip_list(const Property& list) {
    const std::uint32_t count = body_.length(list);
    corners_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      const double value = body_.value(list.type);
      if (ends_strip(value))
        corners_.clear();
      else
        extend_strip(body_.checked_index(value, static_cast<double>(mesh_.positions.size()) - 1.0, "a vertex"));
    }
  }

  /// Every second triangle of a strip winds the other way. Two equal corners are how strips are joined.
  void extend_strip(std::uint32_t corner) {
    corners_.push_back(corner);
    const std::size_t n = corners_.size();
    if (n < 3) return;
    std::uint32_t a = corners_[n - 3], b = corners_[n - 2];
    if (n % 2 == 0) std::swap(a, b);
    if (a != b && b != corner && a != corner) mesh_.triangles.push_back({a, b, corner});
  }

  FaceColumns face_columns(const Element& element) {
    Columns columns(element);
    FaceColumns found;
    found.corners = corners_column(columns, "faces");
    found.uvs = columns.list("texcoord");
    if (found.uvs >= 0 && !mesh_.uvs.empty())
      context_.warning(fmt::format("{}: the texture coordinates of vertices are left out: faces have their own.", name_));
    found.texture = columns.value("texnumber");
    if (mesh_.colors.empty()) found.color = columns.color();
    if (mesh_.alphas.empty()) found.alpha = columns.alpha();
    columns.warn_of_unread(name_, context_);
    result_.own = {found.uvs >= 0, found.color.has_value(), found.alpha >= 0};
    return found;
  }

  void read_faces(const Element& element) {
    const FaceColumns columns = face_columns(element);
    if (columns.has_look()) result_.looks.resize(mesh_.triangles.size());
    row_.assign(element.properties.size(), 0.0);
    for (std::int64_t row = 0; row < element.count; ++row) {
      body_.set_place(element.name, row);
      corners_.clear(), outline_.clear(), uvs_.clear();
      for (std::size_t i = 0; i < element.properties.size(); ++i) read_face_property(element.properties[i], i, columns);
      add_face(element, columns);
    }
  }

  void read_face_property(const Property& property, std::size_t column, const FaceColumns& columns) {
    const int i = static_cast<int>(column);
    if (i == columns.corners) {
      const std::uint32_t count = body_.length(property, static_cast<double>(mesh_.positions.size()));
      for (std::uint32_t k = 0; k < count; ++k) corners_.push_back(read_vertex(property.type));
    } else if (i == columns.uvs) {
      const std::uint32_t count = body_.length(property);
      for (std::uint32_t k = 0; k < count; ++k) uvs_.push_back(static_cast<float>(body_.bounded(property.type)));
    } else if (property.count_type) {
      body_.pass_over(property);
    } else {
      row_[column] = body_.bounded(property.type);
    }
  }

  void add_face(const Element& element, const FaceColumns& columns) {
    for (const std::uint32_t corner : corners_) outline_.push_back(mesh_.positions[corner]);
    if (corners_.size() > kMostConcaveCorners && !turns_one_way(outline_))
      throw body_.error(fmt::format("is not convex and has {} corners", corners_.size()),
                        fmt::format("at most {}", kMostConcaveCorners));
    if (!uvs_.empty() && uvs_.size() != 2 * corners_.size())
      throw body_.error(fmt::format("has {} corners and {} values texcoord", corners_.size(), uvs_.size()),
                        "two values for each corner, or none");
    const FaceLook look = columns.has_look() ? face_look(element, columns) : FaceLook{};
    for (const Triangle& t : triangulate(outline_)) {
      mesh_.triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
      if (!columns.has_look()) continue;
      result_.looks.push_back(look);
      for (std::size_t k = 0; k < 3 && !uvs_.empty(); ++k)
        result_.looks.back().uvs[k] = {uvs_[2 * t[k]], 1.0f - uvs_[2 * t[k] + 1]};
    }
  }

  FaceLook face_look(const Element& element, const FaceColumns& columns) {
    FaceLook look;
    if (columns.color) look.color = color(element, *columns.color);
    if (columns.alpha >= 0) look.alpha = static_cast<float>(share(element, columns.alpha));
    const bool has_uvs = columns.uvs < 0 || !uvs_.empty();
    look.texture = !has_uvs ? -1 : columns.texture >= 0 ? texture_number(columns.texture) : 0;
    return look;
  }

  void skip(const Element& element) {
    LeftOut left_out;
    left_out.add(element.name, name_);
    if (element.count > 0) left_out.warn(context_, "element", "elements");
    body_.pass_over(element);
  }

  const std::string& name_;
  const Header& header_;
  Body& body_;
  const Context& context_;
  PlyMesh result_;
  Mesh& mesh_ = result_.mesh;
  std::vector<double> row_;
  std::vector<std::uint32_t> corners_;  ///< the corners of the face that is being read
  std::vector<Vec3f> outline_;
  std::vector<float> uvs_;
  std::size_t cut_colors_ = 0;
  double color_scale_ = 1.0;
};

/// Where only vertices say which picture is theirs, a triangle has that of its first corner.
void spread_vertex_textures(PlyMesh& ply, const Header& header) {
  const bool asks_vertices = !ply.vertex_texture.empty() && header.texture_files.size() > 1 && ply.looks.empty();
  if (!asks_vertices) return;
  for (const auto& triangle : ply.mesh.triangles) ply.looks.push_back({.texture = ply.vertex_texture[triangle[0]]});
}

std::map<int, Mesh> parts_of(PlyMesh& ply, const Header& header) {
  spread_vertex_textures(ply, header);
  if (!ply.looks.empty()) return split_faces(ply.mesh, ply.looks, ply.own);
  std::map<int, Mesh> parts;
  parts.emplace(0, std::move(ply.mesh));
  return parts;
}

MetallicRoughness surface_of(const Mesh& mesh, int texture) {
  MetallicRoughness surface;
  surface.base_color = Vec4f(Vec3f(mesh.colors.empty() && texture < 0 ? 0.8f : 1.0f), 1.0f);
  surface.base_color_map.texture = texture;
  surface.metallic = 0.0f;
  surface.double_sided = true;
  surface.blend = std::any_of(mesh.alphas.begin(), mesh.alphas.end(), [](float alpha) { return alpha < 1.0f; });
  return surface;
}

void add_instance(Mesh mesh, int texture, Scene& scene) {
  Instance instance;
  instance.name = "mesh";
  instance.shape = instance.material = static_cast<int>(scene.shapes.size());
  scene.materials.push_back({"surface", surface_of(mesh, texture)});
  scene.shapes.emplace_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

/// Where the file's pictures are among the scene's textures; -1: cannot be shown.
std::vector<int> find_textures(const std::string& name, const Header& header, bool has_uvs, SideTextures& textures,
                               const Context& context) {
  std::vector<int> found;
  if (has_uvs) {
    for (const std::string& file : header.texture_files) found.push_back(textures.add(file, name));
    if (header.texture_files.empty())
      context.warning(
          fmt::format("{}: has texture coordinates and names no picture; \"comment TextureFile NAME\" in its "
                      "header names one.",
                      name));
  } else if (!header.texture_files.empty()) {
    context.warning(fmt::format("{}: has no texture coordinates, so its picture {} is left out.", name,
                                shown(header.texture_files.front())));
  }
  return found;
}

}  // namespace

void read_mesh(const std::string& name, const Header& header, Body& body, SideTextures& textures, const Context& context,
               Scene& scene) {
  PlyMesh ply = MeshReader(name, header, body, context).read();
  const std::vector<int> found = find_textures(name, header, !ply.mesh.uvs.empty() || ply.own.uvs, textures, context);
  bool replaced = false;
  for (auto& [number, mesh] : parts_of(ply, header)) {
    const auto i = static_cast<std::size_t>(number);
    const int texture = number >= 0 && i < found.size() ? found[i] : -1;
    if (texture >= 0 && !mesh.colors.empty()) mesh.colors.clear(), replaced = true;
    wind_by_normals(mesh);
    add_instance(std::move(mesh), texture, scene);
  }
  if (replaced)
    context.warning(fmt::format("{}: the properties red, green and blue are left out: a picture is shown instead.", name));
}

}  // namespace lippmann::ply
