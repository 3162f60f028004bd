// The viewer is at (x, y, d) and looks along -z with half angle a. The viewer sees a point p if it is inside the four sides of
// the view pyramid. Two sides limit the width:
//   +-(p.x - x) cos a + p.z sin a <= d sin a.
// Let R be the largest p.x cos a + p.z sin a of all points, and L the largest -p.x cos a + p.z sin a. Both sides touch the
// points for
//   x = (R - L) / (2 cos a),   d = (R + L) / (2 sin a).
// The height is computed in the same way. The larger of the two d is used.
#include "lippmann/stage/fit_array.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "scene/default_view.hpp"
#include "scene/deform.hpp"
#include "stage/read_view_wish.hpp"
#include "stage/seen_bounds.hpp"
#include "stage/subject.hpp"

namespace lippmann {
namespace {

/// Smallest distance from the viewer to the plane, as a multiple of the diagonal of the visible part of the scene.
constexpr float kNearestPlane = 0.05f;
constexpr float kDefaultFov = radians(45.0f);
constexpr float kMargin = 1.05f;  ///< visible size / size of the content

Affine3f similarity(const Affine3f& a) {
  const float scale = uniform_scale(a);
  if (!(scale > 0.0f) || !std::isfinite(scale))
    throw Error("scene", "the node that carries the lens array has a scale of 0", "a scale other than 0");
  const Vec3f z = glm::normalize(a.linear[2]);
  const Vec3f y = glm::normalize(a.linear[1] - glm::dot(a.linear[1], z) * z);
  return {scale * Mat3f(glm::cross(y, z), y, z), a.translation};
}

Mat3f rotation_of(const Affine3f& similarity) { return similarity.linear / uniform_scale(similarity); }

struct Setting {
  const Scene& scene;
  const ResolvedScene& resolved;
  const Subject& subject;
  float aspect;
};

/// Returns the world units per unit of a node at frame 0.
float world_units(const Setting& setting, int node) {
  constexpr float kRounding = 1e-5f;
  const float scale = uniform_scale(similarity(setting.resolved.of(node)));
  return std::abs(scale - 1.0f) <= kRounding ? 1.0f : scale;
}

/// Returns the coordinate system of an array attached to the node. Its origin and axes are those of the node, and its unit of
/// length is the world unit at frame 0.
Affine3f world_from_frame(const Setting& setting, int node, const ResolvedScene& resolved) {
  const Affine3f world_from_node = similarity(resolved.of(node));
  return {world_from_node.linear / world_units(setting, node), world_from_node.translation};
}

Camera in_world_units(Camera camera, float units) {
  camera.focus_distance *= units, camera.orthographic_height *= units, camera.near_distance *= units;
  return camera;
}

DisplayPlacement in_world_units(DisplayPlacement display, float units) {
  display.plane_height *= units, display.viewing_distance *= units;
  return display;
}

template <class Visit>
void visit_frames(const Scene& scene, const Visit& visit) {
  const std::vector<bool> moves = moving_instances(scene), nodes_move = moving_nodes(scene);
  const auto any = [](const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); };
  const bool is_still = !any(moves) && !any(nodes_move);
  for (const int frame : sampled_frames(scene.timeline)) {
    if (frame > 0 && is_still) return;
    visit(evaluate(scene, scene.timeline.time(frame)));
  }
}

/// `half` is half of the width and height at distance 1, or at every distance of an orthographic camera.
struct CameraView {
  bool is_orthographic;
  Vec2f half;
};

CameraView view_of(const Camera& camera) {
  const bool is_orthographic = camera.orthographic_height > 0.0f;
  const float own = is_orthographic ? 0.5f * camera.orthographic_height : std::tan(0.5f * camera.vertical_fov);
  return {is_orthographic, {own * camera.aspect, own}};
}

ConvexRegion region_of(const CameraView& view) {
  return view.is_orthographic ? beam_region(view.half) : view_region(Vec3f(0.0f), view.half);
}

/// Places the array at a distance from a camera, perpendicular to its axis and as large as the view. The viewer is at the
/// camera. The viewer of an orthographic camera is farther away if necessary, so that the view covers at most the default
/// angle.
void place_before_camera(FittedArray& array, const Camera& camera, float distance, const CameraView& view) {
  array.node_from_plane = {Mat3f(1.0f), {0.0f, 0.0f, -distance}};
  array.plane_height = 2.0f * view.half.y * (view.is_orthographic ? 1.0f : distance);
  array.viewing_distance = distance;
  if (view.is_orthographic) array.viewing_distance = std::max(distance, view.half.y / std::tan(0.5f * kDefaultFov));
  array.near_distance = array.viewing_distance - distance + camera.near_distance;
}

std::string camera_name(const Camera& camera) {
  return camera.name.empty() ? std::string("the camera") : fmt::format("camera '{}'", printable(camera.name));
}

enum class Part { kSubject, kBackdrop, kAll };

bool is_part(const Subject& subject, std::size_t instance, Part part) {
  if (part == Part::kAll) return subject.roles[instance] != InstanceRole::kUnseen;
  return subject.roles[instance] == (part == Part::kSubject ? InstanceRole::kSubject : InstanceRole::kBackdrop);
}

SeenParts seen_of(const Setting& setting, Part part, const ResolvedScene& resolved, const Affine3f& frame_from_world,
                  const ConvexRegion& region) {
  SeenParts seen;
  for (std::size_t i = 0; i < setting.scene.instances.size(); ++i)
    if (is_part(setting.subject, i, part))
      seen.add(seen_parts(setting.scene, setting.scene.instances[i], resolved, frame_from_world, region));
  return seen;
}

float width_of_subject(const Setting& setting, const Camera& camera, const CameraView& view) {
  float half = 0.0f;
  visit_frames(setting.scene, [&](const ResolvedScene& resolved) {
    const Affine3f camera_from_world = inverse(world_from_frame(setting, camera.node, resolved));
    const SeenParts seen = seen_of(setting, Part::kSubject, resolved, camera_from_world, region_of(view));
    if (!view.is_orthographic)
      half = std::max(half, seen.tangent.x);
    else if (!seen.bounds.empty())
      half = std::max({half, -seen.bounds.lower.x, seen.bounds.upper.x});
  });
  return half;
}

/// Returns the view of the image, which is as high as the camera's view. If the scene file states no resolution (glTF),
/// enlarges the view where it would cut off the sides of the subject.
CameraView view_for(const Setting& setting, const Camera& camera) {
  const CameraView own = view_of(camera);
  float height = own.half.y;
  if (setting.scene.resolution.x <= 0 && camera.aspect > 1.001f * setting.aspect)
    height = std::max(height, std::min(own.half.x, kMargin * width_of_subject(setting, camera, own)) / setting.aspect);
  return {own.is_orthographic, {height * setting.aspect, height}};
}

std::string left_out_sentence(const Setting& setting) {
  std::string text;
  if (setting.subject.has_surroundings())
    text += fmt::format(" Left out as surroundings: {}.", list_surroundings(setting.scene, setting.subject));
  if (const std::string strays = list_strays(setting.scene, setting.subject); !strays.empty())
    text += fmt::format(" Left out as far away: {}.", strays);
  return text;
}

std::string stray_sentence(const Setting& setting) {
  const std::string strays = list_strays(setting.scene, setting.subject);
  if (strays.empty()) return {};
  return fmt::format("The view leaves out what lies far away from everything else: {}{}", strays,
                     setting.subject.main_part ? "; a view that is fitted to a node shows it" : "");
}

std::string widened_sentence(const Camera& camera, const CameraView& view) {
  const float own = view_of(camera).half.y, tangent_y = view.half.y;
  if (tangent_y <= 1.001f * own) return {};
  if (view.is_orthographic)
    return fmt::format(
        " The view is {:.4g} units high instead of {:.4g}, so that all of the subject that the camera shows fits.",
        2.0f * tangent_y, 2.0f * own);
  return fmt::format(
      " The view is {:.3g} degrees high instead of {:.3g}, so that all of the subject that the camera shows fits.",
      degrees(2.0f * std::atan(tangent_y)), degrees(camera.vertical_fov));
}

FittedArray as_placed(const DisplayPlacement& display) {
  FittedArray array;
  array.origin = FittedArray::Origin::kPlaced;
  array.node = display.node;
  array.plane_height = display.plane_height;
  array.viewing_distance = display.viewing_distance;
  array.how = fmt::format("The scene places the array: {:.4g} units high, viewed from {:.4g} units.", display.plane_height,
                          display.viewing_distance);
  return array;
}

FittedArray at_focus(const Setting& setting, const Camera& camera) {
  FittedArray array;
  array.origin = FittedArray::Origin::kFocus;
  array.node = camera.node;
  const CameraView view = view_for(setting, camera);
  place_before_camera(array, camera, camera.focus_distance, view);
  array.how = fmt::format("The array is at the focus of {}, {:.4g} units away, and fills its view.{}", camera_name(camera),
                          camera.focus_distance, widened_sentence(camera, view));
  return array;
}

/// Places the plane half way through the visible part of the subject, or of everything if the camera does not see the subject.
/// An infinite ground does not count.
FittedArray half_way_through(const Setting& setting, const Camera& camera) {
  FittedArray array;
  array.origin = FittedArray::Origin::kSceneCenter;
  array.node = camera.node;
  const CameraView view = view_for(setting, camera);
  const Affine3f camera_from_world = inverse(world_from_frame(setting, camera.node, setting.resolved));
  const ConvexRegion region = region_of(view);
  Bounds3f seen = seen_of(setting, Part::kSubject, setting.resolved, camera_from_world, region).bounds;
  const bool sees_subject = !seen.empty();
  if (!sees_subject) seen = seen_of(setting, Part::kAll, setting.resolved, camera_from_world, region).bounds;
  const bool sees_nothing = seen.empty();
  if (sees_nothing) seen = finite_bounds(setting.scene, setting.resolved, camera_from_world);
  float distance = 1.0f;
  if (!seen.empty()) {
    const float nearest = std::max(0.0f, -seen.upper.z), farthest = std::max(0.0f, -seen.lower.z);
    const float size = diagonal(seen);
    distance = std::max(0.5f * (nearest + farthest), kNearestPlane * (size > 0.0f ? size : 1.0f));
  }
  place_before_camera(array, camera, distance, view);
  const bool is_scene = sees_nothing || (sees_subject && !setting.subject.has_surroundings());
  if (sees_nothing && !seen.empty()) {
    array.how = fmt::format(
        "Nothing of the scene is seen from {}: the array is {:.4g} units in front of it. A view that is fitted to something, "
        "turned, or of another camera shows more.",
        camera_name(camera), distance);
    return array;
  }
  array.how = fmt::format("The array goes through the middle of {}, {:.4g} units in front of {}, and fills its view.{}{}",
                          is_scene       ? "the scene"
                          : sees_subject ? "its subject"
                                         : "what the camera sees",
                          distance, camera_name(camera), sees_subject ? left_out_sentence(setting) : "",
                          widened_sentence(camera, view));
  return array;
}

struct Direction {
  int node = -1;
  Mat3f node_from_view{1.0f};                      ///< the viewer looks along the view's -z axis
  float tangent_y = std::tan(0.5f * kDefaultFov);  ///< half the view's height / distance
};

/// Bounds of the subject over the animation. `straight` has the bounds along the axes of the view.
struct SubjectBounds {
  Bounds3f straight;
  Vec2f right_up{-kInfinity}, left_down{-kInfinity};  ///< R and L (see the top of the file) of width (x) and height (y)
};

SubjectBounds bounds_in_view(const Setting& setting, const Direction& direction, Vec2f cosine, Vec2f sine) {
  // The matrix `width` computes x cos + z sin and -x cos + z sin. The matrix `height` computes the same with y instead of x.
  // The third rows are unused.
  const Affine3f width{glm::transpose(Mat3f({cosine.x, 0, sine.x}, {-cosine.x, 0, sine.x}, {0, 0, 1})), Vec3f(0.0f)};
  const Affine3f height{glm::transpose(Mat3f({0, cosine.y, sine.y}, {0, -cosine.y, sine.y}, {0, 0, 1})), Vec3f(0.0f)};
  SubjectBounds all;
  visit_frames(setting.scene, [&](const ResolvedScene& resolved) {
    const Affine3f view_from_node{glm::transpose(direction.node_from_view), Vec3f(0.0f)};
    const Affine3f view_from_world = view_from_node * inverse(world_from_frame(setting, direction.node, resolved));
    for (std::size_t i = 0; i < setting.scene.instances.size(); ++i) {
      if (!setting.subject.contains(i)) continue;
      const auto bounds = [&](const Affine3f& frame) {
        return bounds_of_part(setting.scene, setting.subject, i, resolved, frame * view_from_world);
      };
      all.straight.add(bounds({}));
      const Vec3f across = bounds(width).upper, up = bounds(height).upper;
      all.right_up = glm::max(all.right_up, Vec2f(across.x, up.x));
      all.left_down = glm::max(all.left_down, Vec2f(across.y, up.y));
    }
  });
  return all;
}

/// Returns the position (x, y) of the image's centre at which opposite margins are equal, for a viewer at `distance` from the
/// subject's middle. Along an axis that the subject does not fill, measures the bounds again for the angle that the subject
/// covers.
Vec2f middle_from(const Setting& setting, const Direction& direction, const SubjectBounds& bounds, Vec2f angle,
                  float distance) {
  constexpr int kMostPasses = 4;
  constexpr float kSettled = 0.01f;
  const Vec2f largest = glm::sin(angle), cosine = glm::cos(angle);
  const float plane_z = bounds.straight.center().z, away = plane_z + distance;
  const Vec2f least = (bounds.right_up - away * largest) / cosine, most = (away * largest - bounds.left_down) / cosine;
  SubjectBounds seen = bounds;
  Vec2f sine = largest, middle = (seen.right_up - seen.left_down) / (2.0f * cosine);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const Vec2f reach = seen.right_up + seen.left_down - 2.0f * plane_z * sine;
    const Vec2f next = glm::clamp(reach / (2.0f * distance), Vec2f(0.0f), largest);
    if (glm::all(glm::lessThanEqual(glm::abs(next - sine), kSettled * largest))) break;
    sine = next;
    const Vec2f along = glm::sqrt(1.0f - sine * sine);
    seen = bounds_in_view(setting, direction, along, sine);
    middle = (seen.right_up - seen.left_down) / (2.0f * along);
  }
  return glm::clamp(middle, least, glm::max(least, most));
}

FittedArray fitted_to_bounds(const Setting& setting, const Direction& direction) {
  FittedArray array;
  array.origin = FittedArray::Origin::kBounds;
  array.node = direction.node;
  const Vec2f angle = glm::atan(Vec2f(direction.tangent_y * setting.aspect, direction.tangent_y) / kMargin);
  const Vec2f cosine = glm::cos(angle), sine = glm::sin(angle);
  SubjectBounds bounds = bounds_in_view(setting, direction, cosine, sine);
  if (bounds.straight.empty()) {
    bounds.straight.add(Vec3f(0.0f));
    bounds.right_up = bounds.left_down = sine;
  }
  const Vec2f enough = (bounds.right_up + bounds.left_down) / (2.0f * sine);
  const Vec3f size = bounds.straight.size();
  const float plane_z = bounds.straight.center().z;
  // The viewer stays outside the subject, even if it is a point or a rod seen along its length.
  const float least = size == Vec3f(0.0f) ? 1.0f : 0.5f * size.z + kNearestPlane * diagonal(bounds.straight);
  const float distance = std::max(std::max(enough.x, enough.y) - plane_z, least);
  const Vec2f middle = middle_from(setting, direction, bounds, angle, distance);
  place_before_camera(array, {}, distance, {false, Vec2f(direction.tangent_y)});
  array.node_from_plane = {direction.node_from_view, direction.node_from_view * Vec3f(middle, plane_z)};
  array.depth_front = bounds.straight.upper.z - plane_z;
  array.depth_back = bounds.straight.lower.z - plane_z;
  return array;
}

Mat3f turned(const Mat3f& world_from_view, const Orbit& orbit) {
  const float elevation = degrees(std::asin(std::clamp(world_from_view[2].y, -1.0f, 1.0f)));
  const bool is_upright = world_from_view[1].y >= 0.0f;
  const float pitch = is_upright ? std::clamp(orbit.pitch_deg, -90.0f - elevation, 90.0f - elevation) : orbit.pitch_deg;
  const Quatf yaw = glm::angleAxis(radians(orbit.yaw_deg), Vec3f(0.0f, 1.0f, 0.0f));
  const Quatf up = glm::angleAxis(-radians(pitch), Vec3f(1.0f, 0.0f, 0.0f));
  return glm::mat3_cast(yaw) * world_from_view * glm::mat3_cast(up);
}

Mat3f turned_in_node(const Setting& setting, int node, const Mat3f& node_from_view, const Orbit& orbit) {
  if (orbit == Orbit{}) return node_from_view;
  const Mat3f world_from_node = rotation_of(similarity(setting.resolved.of(node)));
  return glm::transpose(world_from_node) * turned(world_from_node * node_from_view, orbit);
}

Direction direction_of(const Scene& scene) {
  Direction direction;
  if (scene.display) {
    direction.node = scene.display->node;
    if (std::isfinite(scene.display->viewing_distance))
      direction.tangent_y = 0.5f * scene.display->plane_height / scene.display->viewing_distance;
  } else if (!scene.cameras.empty()) {
    direction.node = scene.cameras.front().node;
    direction.tangent_y = std::tan(0.5f * scene.cameras.front().vertical_fov);
  } else {
    direction.node_from_view = glm::mat3_cast(default_view());
  }
  return direction;
}

FittedArray without_camera(const Setting& setting, const Orbit& orbit) {
  Direction direction = direction_of(setting.scene);
  direction.node_from_view = turned(direction.node_from_view, orbit);
  FittedArray array = fitted_to_bounds(setting, direction);
  const bool is_part = setting.subject.has_surroundings() || setting.subject.main_part;
  array.how = fmt::format(
      "The scene has no camera: the array goes through {} middle and is viewed from {:.4g} units away, {}, so that {} fits "
      "into the picture.{}",
      is_part ? "its subject's" : "its", array.viewing_distance,
      orbit == Orbit{} ? "a little from above and from the right" : "turned by the orbit", is_part ? "the subject" : "it",
      left_out_sentence(setting));
  return array;
}

bool is_whole_scene(const Scene& scene, const std::string& name) { return name == "all" && !is_name_of_node(scene, name); }

FittedArray fitted_to(const Setting& setting, const std::string& name, const Orbit& orbit) {
  Direction direction = direction_of(setting.scene);
  direction.node_from_view = turned_in_node(setting, direction.node, direction.node_from_view, orbit);
  FittedArray array = fitted_to_bounds(setting, direction);
  const char* from = !(orbit == Orbit{})              ? ", turned by the orbit"
                     : setting.scene.display          ? ", from the direction of the scene's display"
                     : !setting.scene.cameras.empty() ? ", from the camera's direction"
                                                      : "";
  array.how = fmt::format("The view is fitted to {}: the array goes through its middle and is viewed from {:.4g} units away{}.",
                          is_whole_scene(setting.scene, name) ? "the whole scene" : shown(name), array.viewing_distance, from);
  return array;
}

float wanted_plane_z(const FittedArray& array, const Setting& setting, const std::string& focus) {
  const Affine3f world_from_plane = world_from_frame(setting, array.node, setting.resolved) * array.node_from_plane;
  const Affine3f plane_from_world = inverse(world_from_plane);
  if (is_name_of_node(setting.scene, focus)) {
    Bounds3f bounds;
    const std::vector<bool> meant = instances_named(setting.scene, focus, "focus");
    for (std::size_t i = 0; i < meant.size(); ++i)
      if (meant[i]) bounds.add(finite_bounds(setting.scene, setting.scene.instances[i], setting.resolved, plane_from_world));
    if (bounds.empty())
      throw usage_error("focus", shown(focus) + " is infinite and has no centre", "a node that shows a shape");
    return bounds.center().z;
  }
  const std::vector<double> numbers = read_focus(setting.scene, focus);
  if (numbers.size() == 3) {
    const Vec3d in_file(numbers[0], numbers[1], numbers[2]);
    return transform_point(plane_from_world, Vec3f(in_file - setting.scene.origin)).z;
  }
  if (!std::isfinite(array.viewing_distance))
    throw usage_error("focus", "cannot be a distance: the viewer is infinitely far away", "a node or X,Y,Z");
  return array.viewing_distance - static_cast<float>(numbers[0]) / uniform_scale(world_from_plane);
}

bool shows_a_beam(const FittedArray& array, const Scene& scene) {
  using Origin = FittedArray::Origin;
  return (array.origin == Origin::kFocus || array.origin == Origin::kSceneCenter) &&
         view_of(scene.cameras.front()).is_orthographic;
}

/// Moves the plane along the axis of the view. The viewer and the view stay the same.
void focus_at(FittedArray& array, const Setting& setting, const std::string& focus) {
  if (focus.empty()) return;
  const float z = wanted_plane_z(array, setting, focus), distance = array.viewing_distance - z;
  if (!(distance > 1e-6f * array.viewing_distance) && std::isfinite(array.viewing_distance))
    throw usage_error("focus", shown(focus) + " does not lie in front of the viewer", "a visible node or point");
  if (std::isfinite(array.viewing_distance) && !shows_a_beam(array, setting.scene))
    array.plane_height *= distance / array.viewing_distance;
  array.node_from_plane.translation += z * array.node_from_plane.linear[2];
  array.viewing_distance = distance;
  array.depth_front -= z, array.depth_back -= z;
  array.how += std::isfinite(distance)
                   ? fmt::format(" The focus on {} puts the plane {:.4g} units from the viewer.", printable(focus), distance)
                   : fmt::format(" The focus on {} moves the plane.", printable(focus));
}

void turn(FittedArray& array, const Setting& setting, const Orbit& orbit) {
  if (orbit == Orbit{}) return;
  array.node_from_plane.linear = turned_in_node(setting, array.node, array.node_from_plane.linear, orbit);
  array.how +=
      fmt::format(" The orbit turns the view by {:g} degrees to the right and {:g} upwards about the middle of the plane.",
                  orbit.yaw_deg, orbit.pitch_deg);
}

void zoom_in(FittedArray& array, float factor) {
  if (factor == 1.0f) return;
  array.plane_height /= factor;
  array.how += fmt::format(" The zoom shows it {:g} times as large.", factor);
}

void measure_all_depth(FittedArray& array, const Setting& setting, const Affine3f& plane_from_world) {
  const Bounds3f bounds = finite_bounds(setting.scene, setting.resolved, plane_from_world);
  if (bounds.empty()) return;
  array.depth_front = std::min(bounds.upper.z, array.viewing_distance);
  array.depth_back = std::min(bounds.lower.z, array.viewing_distance);
}

/// The depth range covers the subject and visible walls within one diagonal of the subject, but not the ground.
void measure_depth(FittedArray& array, const Setting& setting, const Affine3f& plane_from_world, Bounds3f subject) {
  const float tangent = 0.5f * array.plane_height / array.viewing_distance;
  ConvexRegion region = view_region({0.0f, 0.0f, array.viewing_distance}, {tangent * setting.aspect, tangent});
  const auto seen = [&](Part part) { return seen_of(setting, part, setting.resolved, plane_from_world, region).bounds; };
  if (subject.empty()) subject = seen(Part::kSubject);
  if (subject.empty()) subject = seen(Part::kAll);
  if (subject.empty()) return measure_all_depth(array, setting, plane_from_world);
  const float reach = diagonal(subject);
  region.push_back({{0.0f, 0.0f, 1.0f}, reach - subject.lower.z});
  region.push_back({{0.0f, 0.0f, -1.0f}, subject.upper.z + reach});
  subject.add(seen(Part::kBackdrop));
  array.depth_front = std::min(subject.upper.z, array.viewing_distance);
  array.depth_back = std::min(subject.lower.z, array.viewing_distance);
}

Bounds3f bounds_over_animation(const FittedArray& array, const Setting& setting) {
  Bounds3f bounds;
  visit_frames(setting.scene, [&](const ResolvedScene& resolved) {
    const Affine3f plane_from_world = inverse(world_from_frame(setting, array.node, resolved) * array.node_from_plane);
    for (std::size_t i = 0; i < setting.scene.instances.size(); ++i)
      if (setting.subject.contains(i))
        bounds.add(bounds_of_part(setting.scene, setting.subject, i, resolved, plane_from_world));
  });
  return bounds;
}

void measure_depth(FittedArray& array, const Setting& setting) {
  const Affine3f plane_from_world = inverse(world_from_frame(setting, array.node, setting.resolved) * array.node_from_plane);
  const bool is_fitted = array.origin == FittedArray::Origin::kBounds;
  if (array.origin == FittedArray::Origin::kPlaced)
    measure_all_depth(array, setting, plane_from_world);
  else
    measure_depth(array, setting, plane_from_world, is_fitted ? bounds_over_animation(array, setting) : Bounds3f{});
}

/// Throws Error if the array is so large, so small or so far away that floats lose precision or overflow.
void check_extent(const FittedArray& array, const Setting& setting) {
  constexpr float kSmallest = 1e-9f, kLargest = 1e15f;
  const float height = array.plane_height;
  if (!(height >= kSmallest && height <= kLargest))
    throw Error("scene", fmt::format("the lens array fitted to it would be {:.4g} units high", std::abs(height)),
                fmt::format("scenes of {:g} to {:g} units", kSmallest, kLargest));
  const Affine3f world_from_array = world_from_frame(setting, array.node, setting.resolved);
  const float away = glm::length(transform_point(world_from_array, array.node_from_plane.translation));
  if (!(away <= kLargest))
    throw Error("scene", fmt::format("the lens array would be {:.4g} units away from the origin", std::abs(away)),
                fmt::format("at most {:g}", kLargest));
}

FittedArray place(const Setting& setting, const ViewWish& wish) {
  const Scene& scene = setting.scene;
  if (!wish.fit_to.empty()) return fitted_to(setting, wish.fit_to, wish.orbit);
  if (scene.display) return as_placed(in_world_units(*scene.display, world_units(setting, scene.display->node)));
  if (scene.cameras.empty()) return without_camera(setting, wish.orbit);
  const Camera camera = in_world_units(scene.cameras.front(), world_units(setting, scene.cameras.front().node));
  return camera.focus_distance > 0.0f ? at_focus(setting, camera) : half_way_through(setting, camera);
}

/// If the scene places a display, the subject is everything.
Subject wanted_subject(const Scene& scene, const ViewWish& wish) {
  if (wish.fit_to.empty()) return scene.display ? whole_scene(scene) : find_subject(scene);
  if (is_whole_scene(scene, wish.fit_to)) return whole_scene(scene);
  const std::vector<bool> meant = instances_named(scene, wish.fit_to, "fit-to");
  Subject subject = whole_scene(scene);
  for (std::size_t i = 0; i < meant.size(); ++i) {
    if (meant[i])
      subject.roles[i] = InstanceRole::kSubject;
    else if (subject.contains(i))
      subject.roles[i] = InstanceRole::kGround;
  }
  return subject;
}

}  // namespace

FittedArray fit_array(const Scene& scene, float aspect, const ViewWish& wish) {
  if (!(wish.zoom > 0.0f && std::isfinite(wish.zoom)))
    throw usage_error("zoom", fmt::format("is {}", wish.zoom), "a number above 0");
  if (!std::isfinite(wish.orbit.yaw_deg) || !(std::abs(wish.orbit.pitch_deg) <= 90.0f))
    throw usage_error("orbit", fmt::format("is {},{} degrees", wish.orbit.yaw_deg, wish.orbit.pitch_deg),
                      "YAW,PITCH with a pitch from -90 to 90");
  const ResolvedScene resolved = evaluate(scene, scene.timeline.time(0));
  const Subject subject = wanted_subject(scene, wish);
  const Setting setting{scene, resolved, subject, aspect};
  FittedArray array = place(setting, wish);
  check_extent(array, setting);
  const bool is_turned = array.origin == FittedArray::Origin::kBounds;
  focus_at(array, setting, wish.focus);
  if (!is_turned) turn(array, setting, wish.orbit);
  zoom_in(array, wish.zoom);
  array.leaves_out_surroundings = subject.has_surroundings();
  for (std::size_t i = 0; i < scene.instances.size(); ++i) array.is_subject.push_back(subject.contains(i));
  if (array.origin == FittedArray::Origin::kBounds) array.warning = stray_sentence(setting);
  check_extent(array, setting);
  measure_depth(array, setting);
  const float units = world_units(setting, array.node);
  array.node_from_plane.linear /= units, array.node_from_plane.translation /= units;
  return array;
}

Affine3f world_from_display(const FittedArray& array, float units_per_mm, const ResolvedScene& resolved) {
  const int nodes = static_cast<int>(resolved.world_from_node.size());
  if (array.node < -1 || array.node >= nodes)
    throw Error("array", fmt::format("moves with node {}, but the number of nodes is {}", array.node, nodes),
                "an array that was fitted to this scene");
  const Affine3f plane = similarity(resolved.of(array.node)) * array.node_from_plane;
  return {plane.linear * units_per_mm, plane.translation};
}

}  // namespace lippmann
