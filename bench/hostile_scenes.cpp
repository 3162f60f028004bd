#include "bench/hostile_scenes.hpp"

#include "bench/hostile_builders.hpp"
#include "bench/hostile_parts.hpp"
#include "bench/scenes.hpp"

namespace lippmann::bench {
namespace {

RenderParams path_params_of(const std::string& name) {
  RenderParams params = params_of(name);
  params.sampling.integrator = Integrator::kPath;
  return params;
}

RenderParams quilt(const std::string& name, Extent<int> views, int view_pixels) {
  RenderParams params = path_params_of(name);
  params.optics.kind = OpticsKind::kMultiview;
  params.optics.views = views;
  params.optics.size = {views.x * view_pixels, views.y * view_pixels};
  return params;
}

HostileScene three_views(std::string name, std::string difficulty, std::function<Scene()> build) {
  RenderParams params = quilt(name, {3, 1}, 120);
  return {std::move(name), std::move(difficulty), std::move(build), std::move(params)};
}

HostileScene many_views(std::string name, std::string difficulty, std::function<Scene()> build) {
  HostileScene scene = three_views(std::move(name), std::move(difficulty), std::move(build));
  scene.params = quilt(scene.name, {8, 6}, 48);
  return scene;
}

HostileScene lenticular(std::string name, std::string difficulty, std::function<Scene()> build) {
  HostileScene scene = three_views(std::move(name), std::move(difficulty), std::move(build));
  scene.params = path_params_of(scene.name);
  return scene;
}

}  // namespace

const std::vector<HostileScene>& hostile_scenes() {
  static const std::vector<HostileScene> all{
      three_views("bar-sun", "a hard shadow of a sky's sun sweeps over a floor", bar_below_sun),
      three_views("bar-lamp", "a soft shadow sweeps over a floor", bar_below_lamp),
      three_views("fast-lamp", "all light moves: a glowing ball flies around a post", fast_lamp),
      three_views("fast-point", "all light moves, and its shadows are hard: a point light flies around a post",
                  fast_point_light),
      three_views("tiny-lamp", "a lamp of 8 mm, which random paths almost never hit, and a rotating box", tiny_lamp),
      three_views("flash", "a lamp that is on in some frames only, and a moving glowing ball", flashing_lamps),
      three_views("mirrors", "three mirror walls show a rolling ball again and again", mirror_walls),
      three_views("glass", "glass moves in front of a textured wall: refraction and caustics", glass_things),
      three_views("gloss", "metal and plastic of roughness 0.15 to 0.5, turning: what they show depends on the view",
                  glossy_things),
      three_views("thin", "rods and wires of 1/4 to 1 pixel, moving slowly: no pixel shows a single surface", thin_things),
      three_views("flight", "the array itself flies through a room: every pixel shows something else", flight_through_room),
      three_views("walker", "a skinned mesh bends and walks: no part of it is rigid", walker),
      three_views("turntable", "boxes on a disc rotate in a static hall", turntable),
      three_views("textured", "checkers of 2-pixel squares and grain everywhere: light must be separated from colour",
                  textured_room),
      three_views("furnished", "a ceiling has only indirect light, while a door and a cart move in the sun", furnished_room),
      three_views("millimetres", "bar-lamp, a thousand times smaller", [] { return scaled(bar_below_lamp(), 1e-3f); }),
      three_views("kilometres", "bar-lamp, a thousand times larger", [] { return scaled(bar_below_lamp(), 1e3f); }),
      many_views("views-48", "gloss in 8 x 6 views of 48 x 48 pixels", glossy_things),
      lenticular("large", "bar-lamp behind 64 lenses, 512 x 512 pixels", bar_below_lamp)};
  return all;
}

}  // namespace lippmann::bench
