#include "stage/subject.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <variant>

#include "core/printable.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/deform.hpp"
#include "scene/splats.hpp"
#include "stage/main_part.hpp"
#include "stage/seen_bounds.hpp"

namespace lippmann {
namespace {

constexpr float kThin = 0.1f;  ///< maximum thickness of a sheet, as a fraction of its longest side
/// Largest distance of a sheet from a face of the bounding box, as a fraction of the box's size.
constexpr float kNearFace = 0.05f;
constexpr float kSpanning = 0.8f;  ///< fraction of a face that its sheets must span
/// Surroundings are removed only if the bounding box of the rest has at most this fraction of the whole diagonal.
constexpr float kMuchSmaller = 0.5f;
/// Replaces kMuchSmaller if the surroundings have no ground.
constexpr float kSmallBefore = 0.25f;

using Indices = std::vector<std::size_t>;

struct Face {
  int axis;
  bool upper;
};
constexpr Face kFloorFace{1, false}, kCeilingFace{1, true};
constexpr std::array<Face, 4> kWallFaces{{{0, false}, {0, true}, {2, false}, {2, true}}};

/// Removes surroundings layer by layer, such as a room on a lawn below a sky.
class Peeling {
 public:
  explicit Peeling(const Scene& scene) : scene_(scene), subject_(whole_scene(scene)) {
    measure();
    leave_out_strays();
    for (std::size_t i = 0; i < bounds_.size(); ++i)
      if (subject_.contains(i) && !bounds_[i].empty()) left_.push_back(i);
  }

  Subject run() {
    while (left_.size() > 1 && (peel_sheets() || peel_shell())) {
    }
    return subject_;
  }

 private:
  void measure() {
    bounds_.resize(scene_.instances.size());
    moves_ = moving_instances(scene_);
    const bool any_moves = std::find(moves_.begin(), moves_.end(), true) != moves_.end();
    for (const int frame : sampled_frames(scene_.timeline)) {
      if (frame > 0 && !any_moves) break;
      const ResolvedScene resolved = evaluate(scene_, scene_.timeline.time(frame));
      for (std::size_t i = 0; i < bounds_.size(); ++i)
        if (frame == 0 || moves_[i]) bounds_[i].add(finite_bounds(scene_, scene_.instances[i], resolved));
    }
  }

  Bounds3f bounds_of(const Indices& instances) const {
    Bounds3f all;
    for (const std::size_t i : instances) all.add(bounds_[i]);
    return all;
  }

  Indices without(const Indices& removed) const {
    std::vector<bool> is_removed(bounds_.size(), false);
    for (const std::size_t i : removed) is_removed[i] = true;
    Indices rest;
    for (const std::size_t i : left_)
      if (!is_removed[i]) rest.push_back(i);
    return rest;
  }

  void remove(const Indices& instances, InstanceRole role) {
    for (const std::size_t i : instances)
      if (subject_.contains(i)) subject_.roles[i] = role;
    left_ = without(instances);
  }

  std::vector<ScenePiece> pieces() const {
    std::vector<ScenePiece> pieces;
    const ResolvedScene resolved = evaluate(scene_, scene_.timeline.time(0));
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (!subject_.contains(i) || bounds_[i].empty()) continue;
      const Instance& instance = scene_.instances[i];
      if (moves_[i] || is_posed(scene_, instance)) {
        add_box(bounds_[i], pieces);
        continue;
      }
      std::visit(
          [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Mesh>)
              add_triangles(shape, resolved.of(instance.node), pieces);
            else if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Splats>)
              add_box(bounds_[i], pieces);
            else
              visit_boxes(scene_, instance, resolved, {}, [&](const Bounds3f& box) { add_box(box, pieces); });
          },
          scene_.shapes[static_cast<std::size_t>(instance.shape)]);
    }
    return pieces;
  }

  static void add_box(const Bounds3f& box, std::vector<ScenePiece>& pieces) {
    if (box.empty()) return;
    const Vec3f size = box.size();
    pieces.push_back({box, 2.0f * (size.x * size.y + size.y * size.z + size.z * size.x), false});
  }

  static void add_triangles(const Mesh& mesh, const Affine3f& world_from_mesh, std::vector<ScenePiece>& pieces) {
    std::vector<Vec3f> at;
    for (const Vec3f& p : mesh.positions) at.push_back(transform_point(world_from_mesh, p));
    for (const auto& [a, b, c] : mesh.triangles) pieces.push_back(piece_of_triangle(at[a], at[b], at[c]));
  }

  void leave_out_strays() {
    subject_.main_part = find_main_part(pieces());
    if (!subject_.main_part) return;
    const Bounds3f& part = *subject_.main_part;
    subject_.is_cut.assign(bounds_.size(), false);
    const ResolvedScene resolved = evaluate(scene_, scene_.timeline.time(0));
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      if (!subject_.contains(i) || bounds_[i].empty()) continue;
      const Bounds3f whole = bounds_[i];
      if (glm::all(glm::lessThanEqual(part.lower, whole.lower)) && glm::all(glm::lessThanEqual(whole.upper, part.upper)))
        continue;
      subject_.is_cut[i] = true;
      bounds_[i] = bounds_of_part(scene_, subject_, i, resolved);
      if (bounds_[i].empty()) subject_.roles[i] = InstanceRole::kStray;
    }
  }

  bool is_sheet_at(std::size_t i, Face face, const Bounds3f& all) const {
    const Vec3f size = bounds_[i].size();
    if (size[face.axis] > kThin * std::max({size.x, size.y, size.z})) return false;
    const float gap =
        face.upper ? all.upper[face.axis] - bounds_[i].upper[face.axis] : bounds_[i].lower[face.axis] - all.lower[face.axis];
    return gap <= kNearFace * all.size()[face.axis];
  }

  static bool spans(const Bounds3f& sheet, Face face, const Bounds3f& all) {
    if (sheet.empty()) return false;
    for (int axis = 0; axis < 3; ++axis)
      if (axis != face.axis && sheet.size()[axis] < kSpanning * all.size()[axis]) return false;
    return true;
  }

  /// Returns the sheets at a face of the bounding box, or nothing if these sheets together do not span the face. each: returns
  /// only sheets that alone span the face.
  Indices sheets_at(Face face, const Bounds3f& all, bool each) const {
    Indices sheets;
    for (const std::size_t i : left_)
      if (is_sheet_at(i, face, all) && (!each || spans(bounds_[i], face, all))) sheets.push_back(i);
    return spans(bounds_of(sheets), face, all) ? sheets : Indices{};
  }

  /// Removes sheets if the rest is much smaller than the whole. Returns whether sheets were removed. each: removes only sheets
  /// that alone span a face, such as a table, but not the coins on the table.
  bool peel_sheets(bool each) {
    const Bounds3f all = bounds_of(left_);
    const Indices floor = sheets_at(kFloorFace, all, each);
    Indices walls, ceiling;
    for (const Face face : kWallFaces) {
      const Indices wall = sheets_at(face, all, each);
      walls.insert(walls.end(), wall.begin(), wall.end());
    }
    if (!walls.empty()) ceiling = sheets_at(kCeilingFace, all, each);
    const bool on_ground = has_ground_ || !floor.empty();
    Indices removed = floor;
    removed.insert(removed.end(), walls.begin(), walls.end());
    removed.insert(removed.end(), ceiling.begin(), ceiling.end());
    const Indices rest = without(removed);
    if (removed.empty() || rest.empty()) return false;
    if (diagonal(bounds_of(rest)) > (on_ground ? kMuchSmaller : kSmallBefore) * diagonal(all)) return false;
    has_ground_ = on_ground;
    remove(floor, InstanceRole::kGround);
    remove(ceiling, InstanceRole::kGround);
    remove(walls, InstanceRole::kBackdrop);
    return true;
  }

  bool peel_sheets() { return peel_sheets(true) || peel_sheets(false); }

  /// Returns the instances other than the shell, without sheets such as a ground below a sky.
  Indices core_without(std::size_t shell) const {
    Peeling inner(*this);
    inner.left_ = without({shell});
    while (inner.left_.size() > 1 && inner.peel_sheets()) {
    }
    return inner.left_;
  }

  /// Returns whether the shell leaves free space around the content, except below, of at least half the content's largest side.
  bool leaves_free(std::size_t shell, const Bounds3f& core) const {
    const Vec3f size = core.size();
    const float reach = 0.5f * std::max({size.x, size.y, size.z});
    Bounds3f around{core.lower - Vec3f(reach), core.upper + Vec3f(reach)};
    around.lower.y = core.lower.y + 0.1f * size.y;
    const ResolvedScene resolved = evaluate(scene_, scene_.timeline.time(0));
    return seen_parts(scene_, scene_.instances[shell], resolved, {}, box_region(around)).bounds.empty();
  }

  bool is_shell(std::size_t i) const {
    const Indices core = core_without(i);
    const Bounds3f inner = bounds_of(core), &outer = bounds_[i];
    if (inner.empty() || diagonal(inner) > kSmallBefore * diagonal(outer)) return false;
    for (const int axis : {0, 2})
      if (inner.lower[axis] < outer.lower[axis] || inner.upper[axis] > outer.upper[axis]) return false;
    return leaves_free(i, inner);
  }

  bool peel_shell() {
    const auto smaller = [&](std::size_t a, std::size_t b) { return diagonal(bounds_[a]) < diagonal(bounds_[b]); };
    const std::size_t largest = *std::max_element(left_.begin(), left_.end(), smaller);
    if (!is_shell(largest)) return false;
    remove({largest}, InstanceRole::kBackdrop);
    return true;
  }

  const Scene& scene_;
  std::vector<Bounds3f> bounds_;
  std::vector<bool> moves_;
  Subject subject_;
  Indices left_;
  bool has_ground_ = false;
};

}  // namespace

bool is_surrounding(InstanceRole role) { return role == InstanceRole::kGround || role == InstanceRole::kBackdrop; }

bool Subject::has_surroundings() const { return std::any_of(roles.begin(), roles.end(), is_surrounding); }

Subject whole_scene(const Scene& scene) {
  Subject subject;
  for (const Instance& instance : scene.instances)
    subject.roles.push_back(instance.hidden_from_cameras ? InstanceRole::kUnseen : InstanceRole::kSubject);
  return subject;
}

std::vector<int> sampled_frames(const Timeline& timeline) {
  constexpr int kSampledFrames = 32;
  const int step = std::max(1, timeline.frame_count / kSampledFrames);
  std::vector<int> frames;
  for (int frame = 0; frame < timeline.frame_count; frame += step) frames.push_back(frame);
  return frames;
}

Bounds3f bounds_of_part(const Scene& scene, const Subject& subject, std::size_t instance, const ResolvedScene& resolved,
                        const Affine3f& frame_from_world) {
  const Instance& of = scene.instances[instance];
  if (subject.is_cut.empty() || !subject.is_cut[instance]) return finite_bounds(scene, of, resolved, frame_from_world);
  Bounds3f bounds;
  visit_seen(scene, of, resolved, {}, box_region(*subject.main_part), [&](std::span<const Vec3f> polygon) {
    for (const Vec3f& p : polygon) bounds.add(transform_point(frame_from_world, p));
  });
  return bounds;
}

Subject find_subject(const Scene& scene) { return Peeling(scene).run(); }

namespace {

template <class IsListed>
std::string list_instances(const Scene& scene, const IsListed& is_listed) {
  constexpr std::size_t kListed = 3;
  std::set<std::string> known;
  std::vector<std::string> names;
  std::size_t unnamed = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!is_listed(i)) continue;
    const std::string& name = scene.instances[i].name;
    if (name.empty())
      ++unnamed;
    else if (known.insert(name).second)
      names.push_back(fmt::format("'{}'", printable(name)));
  }
  const std::size_t others = unnamed + (names.size() > kListed ? names.size() - kListed : 0);
  if (names.size() > kListed) names.resize(kListed);
  if (others > 0)
    names.push_back(names.empty() ? (others == 1 ? std::string("one shape") : fmt::format("{} shapes", others))
                                  : fmt::format("{} other{}", others, others == 1 ? "" : "s"));
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

std::string list_surroundings(const Scene& scene, const Subject& subject) {
  return list_instances(scene, [&](std::size_t i) { return is_surrounding(subject.roles[i]); });
}

std::string list_strays(const Scene& scene, const Subject& subject) {
  std::vector<std::string> listed;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const auto* splats = std::get_if<Splats>(&scene.shapes[static_cast<std::size_t>(scene.instances[i].shape)]);
    if (const std::size_t count = splats && subject.contains(i) ? count_far_splats(*splats) : 0; count > 0)
      listed.push_back(fmt::format("{} splat{} of '{}'", count, count == 1 ? "" : "s", printable(scene.instances[i].name)));
  }
  const std::string of_splats = fmt::format("{}", fmt::join(listed, ", "));
  if (!subject.main_part) return of_splats;
  const std::string whole = list_instances(scene, [&](std::size_t i) { return subject.roles[i] == InstanceRole::kStray; });
  const std::string cut =
      list_instances(scene, [&](std::size_t i) { return subject.is_cut[i] && subject.roles[i] != InstanceRole::kStray; });
  const std::string of_meshes = cut.empty() ? whole : fmt::format("{}{}parts of {}", whole, whole.empty() ? "" : ", and ", cut);
  return of_meshes + (of_meshes.empty() || of_splats.empty() ? "" : ", and ") + of_splats;
}

}  // namespace lippmann
