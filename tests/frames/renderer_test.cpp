#include "lippmann/frames/renderer.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/origin.hpp"
#include "lippmann/stage/lighting.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

Optics small_quilt() {
  Optics quilt;
  quilt.panel = {128, 64, 1.0f};
  quilt.model = MultiView{.columns = 2, .rows = 1};
  return quilt;
}

Scene built_in(const char* name) { return load_scene(name, {}, Context{}); }

TEST(Renderer, equals_a_render_by_name) {
  RenderParams params;
  params.scene.name = "primitives";
  params.optics.lenses = {4, 4};
  params.sampling.spp = 2;
  const Context context;
  const ThreadPool pool(1);
  JobStage stage(ResolvedJob(params), pool, context);
  Renderer renderer(built_in("primitives"), {stage.array, stage.placed}, frame_params(ResolvedJob(params)), context);
  const auto maker = make_frame_maker(stage, frame_params(ResolvedJob(params)), pool, context);
  for (const int frame : {3, 4, 9}) {
    const auto made = renderer.frame(frame);
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(made->pictures.film.data, maker->make(frame).pictures.film.data) << frame;
  }
}

TEST(Renderer, places_optics_at_the_cameras_height) {
  const Scene scene = built_in("room");
  const Placement placement = place(scene, small_quilt(), {.fit_depth = false});
  EXPECT_FLOAT_EQ(placement.placed.units_per_mm * 64.0f, placement.array.plane_height);
  EXPECT_EQ(placement.array.plane_height, fit_array(scene, 1.0f).plane_height);
  EXPECT_EQ(placement.placed.depth_scale, 1.0f);
}

/// The camera is 6 units in front of the mesh. Single precision represents all coordinates exactly.
Image picture_of_mesh_at(Vec3f where) {
  Scene scene;
  Mesh mesh;
  mesh.positions = {{-1, -1, 0.5f}, {1, -1, 0}, {0, 1, -0.5f}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (Vec3f& p : mesh.positions) p += where;
  scene.shapes = {mesh};
  scene.materials = {{"", MetallicRoughness{.metallic = 0.0f, .double_sided = true}}};
  scene.instances = {{"", 0, 0, -1}};
  scene.nodes.resize(1);
  scene.nodes[0].local.translation = where + Vec3f(0, 0, 6);
  scene.cameras.resize(1), scene.cameras[0].node = 0;
  scene.background.horizon = scene.background.zenith = Vec3f(0.8f);
  move_near_origin(scene);
  Placement placement = place(scene, small_quilt());
  const Context context;
  return Renderer(std::move(scene), std::move(placement), {}, context).frame(0)->pictures.film;
}

TEST(Renderer, scene_far_from_the_origin_is_exact) {
  // move_near_origin() moves the scene by multiples of 2, here exactly to the origin, so no bit differs.
  EXPECT_EQ(picture_of_mesh_at({4'194'304, 1024, -2'097'152}).data, picture_of_mesh_at(Vec3f(0)).data);
}

TEST(Renderer, placing_refuses_a_scene_with_bad_indices) {
  const auto message = [](const auto& spoil) {
    Scene scene = built_in("primitives");
    spoil(scene);
    return test::error_message([&] { place(scene, small_quilt()); });
  };
  EXPECT_THAT(message([](Scene& s) { s.nodes[0].parent = 1000; }), testing::HasSubstr("parent 1000"));
  EXPECT_THAT(message([](Scene& s) { s.instances[0].node = 1000; }), testing::HasSubstr("node 1000 is out of range"));
  EXPECT_THAT(message([](Scene& s) { s.instances[0].shape = -1; }), testing::HasSubstr("shape -1 is out of range"));
  EXPECT_THAT(message([](Scene& s) { s.cameras[0].node = 1000; }), testing::HasSubstr("node 1000 is out of range"));
  EXPECT_THAT(message([](Scene& s) { s.lights[0].node = 1000; }), testing::HasSubstr("node 1000 is out of range"));
}

TEST(Renderer, lighting_refuses_a_scene_with_bad_indices) {
  Scene scene = built_in("primitives");
  scene.nodes[0].parent = 1000;
  EXPECT_THROW(add_missing_light(scene, Integrator::kPath), Error);
}

TEST(Renderer, fits_depth_to_the_budget) {
  const Scene scene = built_in("room");
  EXPECT_LT(place(scene, small_quilt(), {.fit_depth = true}).placed.depth_scale, 1.0f);
  EXPECT_EQ(place(scene, small_quilt()).placed.depth_scale, 1.0f) << "the display of these views is unknown";
  Optics lenses = small_quilt();
  lenses.model = LenticularSheet{};
  EXPECT_LT(place(scene, lenses).placed.depth_scale, 1.0f);
}

TEST(Renderer, traces_but_does_not_interpolate_ray_tables) {
  const Context context;
  const Scene scene = built_in("primitives");
  Optics view{.panel = {24, 16, 1.0f}, .model = SingleView{.distance_mm = 60.0f}};
  const Placement as_view = place(scene, view);
  Placement as_rays = as_view;
  RayTable table = make_ray_table(view.panel, 1, [&](Vec2f pixel) { return ray_of_pixel(as_view.placed.optics, pixel); });
  table.spread = 1.0f / 60.0f;
  as_rays.placed.optics.model = table;
  const auto film_of = [&](const Placement& placement, const FrameParams& params) {
    return Renderer(scene, placement, params, context).frame(1)->pictures.film;
  };
  const Image traced = film_of(as_view, {}), from_rays = film_of(as_rays, {});
  ASSERT_EQ(traced.data.size(), from_rays.data.size());
  std::size_t different = 0;  // at an edge, rays that differ in their last bits may hit another surface
  for (std::size_t i = 0; i < traced.data.size(); ++i) different += std::abs(traced.data[i] - from_rays.data[i]) > 1e-3f;
  EXPECT_LE(different, traced.data.size() / 100);
  EXPECT_NO_THROW(film_of(as_rays, {.reuse = CopySettled{}}));
  EXPECT_NO_THROW(film_of(as_rays, {.sampling = {.integrator = Integrator::kPath, .spp = 2}}));
  try {
    film_of(as_rays, {.reuse = Interpolate{}});
    FAIL() << "a table of rays was interpolated";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "reuse");
  }
}

/// The walls fill the view, so only pixels outside the camera's aperture are black.
TEST(Renderer, leaves_pixels_beside_the_aperture_black) {
  const Context context;
  const Scene scene = built_in("room");
  const Optics camera{
      .panel = {60, 40, 0.1f},
      .model = PlenopticCamera{.lens_pitch_mm = 0.96f, .gap_mm = 2.0f, .focal_length_mm = 45.0f, .f_number = 1.9f}};
  const Placement placement = place(scene, camera);
  for (const int spp : {1, 4}) {
    const auto frame = Renderer(scene, placement, {.sampling = {.spp = spp}}, context).frame(0);
    int lit = 0, black = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 60; ++x) {
        int blocked = 0;
        for (const Vec2f part : {Vec2f(0.0f), Vec2f(1.0f, 0.0f), Vec2f(0.0f, 1.0f), Vec2f(1.0f), Vec2f(0.5f)})
          blocked += is_blocked(placement.placed.optics, Vec2f(x, y) + 0.98f * part + 0.01f);
        const float* pixel = frame->pictures.film.pixel(x, y);
        const float light = pixel[0] + pixel[1] + pixel[2];
        EXPECT_TRUE(blocked != 0 || light > 0.0f) << x << " " << y << " at " << spp;
        EXPECT_TRUE(blocked != 5 || light == 0.0f) << x << " " << y << " at " << spp;
        lit += blocked == 0, black += blocked == 5;
      }
    EXPECT_GT(lit, 1200);
    EXPECT_GT(black, 250);
  }
}

TEST(Renderer, interpolates_frames_between_key_frames) {
  const Context context;
  const Scene scene = built_in("primitives");
  Renderer renderer(scene, place(scene, small_quilt()), {.reuse = Interpolate{.keyframes = 2}}, context);
  const auto key = renderer.frame(0), in_between = renderer.frame(1);
  ASSERT_TRUE(key && in_between);
  EXPECT_EQ(key->report.kind, "key");
  EXPECT_EQ(in_between->report.kind, "in-between");
}

TEST(Renderer, denoises_paths_by_default) {
  const Context context;
  const Scene scene = built_in("primitives");
  const Placement placement = place(scene, small_quilt());
  const auto film = [&](Denoise denoise) {
    Renderer renderer(scene, placement, {.sampling = {.integrator = Integrator::kPath, .spp = 2, .denoise = denoise}}, context);
    return renderer.frame(0)->pictures.film.data;
  };
  EXPECT_NE(film(Denoise::kAuto), film(Denoise::kNone));
}

TEST(Renderer, has_the_requested_layers) {
  const Context context;
  const Scene scene = built_in("primitives");
  Renderer renderer(scene, place(scene, small_quilt()), {.sampling = {.aov = {Aov::kDepth}}}, context);
  const auto frame = renderer.frame(0);
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->pictures.aovs[Aov::kDepth].width, 128);
}

TEST(Renderer, refuses_missing_frames_and_contradictions) {
  const Context context;
  const Scene scene = built_in("primitives");
  const Placement placement = place(scene, small_quilt());
  Renderer renderer(scene, placement, {}, context);
  EXPECT_THROW(renderer.frame(-1), Error);
  EXPECT_THROW(renderer.frame(scene.timeline.frame_count), Error);
  EXPECT_THROW(Renderer(scene, placement, {.sampling = {.aov = {Aov::kDepth}}, .reuse = Interpolate{}}, context), Error);
  Scene broken = scene;
  broken.instances.front().node = 1 << 20;
  EXPECT_THROW(Renderer(broken, placement, {}, context), Error);
}

TEST(Renderer, refuses_invalid_placements) {
  const Context context;
  const Scene scene = built_in("primitives");
  const Placement good = place(scene, small_quilt());
  const auto message = [&](const auto& spoil) {
    Placement placement = good;
    spoil(placement);
    return test::error_message([&] { Renderer(scene, placement, {}, context); });
  };
  EXPECT_EQ(message([](Placement&) {}), "(no Error)");
  for (const int node : {-2, static_cast<int>(scene.nodes.size()), 90'000'000})
    EXPECT_THAT(message([&](Placement& p) { p.array.node = node; }), testing::HasSubstr("the array moves with node")) << node;
  for (const float size : {0.0f, -1.0f, std::nanf(""), kInfinity}) {
    EXPECT_THAT(message([&](Placement& p) { p.placed.units_per_mm = size; }), testing::HasSubstr("units per mm")) << size;
    EXPECT_THAT(message([&](Placement& p) { p.array.plane_height = size; }), testing::HasSubstr("height of the array")) << size;
  }
  EXPECT_THAT(message([](Placement& p) { p.placed.optics.panel.width = -5; }), testing::HasSubstr("panel.width"));
  EXPECT_THAT(message([](Placement& p) { p.placed.optics.model = RayTable{}; }), testing::HasSubstr("rays"));
}

TEST(Renderer, keeps_a_context_that_is_a_temporary) {
  const Scene scene = built_in("primitives");
  const Placement placement = place(scene, small_quilt());
  const Context context;
  const auto expected = Renderer(scene, placement, {}, context).frame(0);
  int calls = 0;
  Renderer renderer(scene, placement, {}, Context{.threads = 1, .frame_progress = [&](double) { ++calls; }});
  EXPECT_EQ(renderer.frame(0)->pictures.film.data, expected->pictures.film.data);
  EXPECT_GT(calls, 0);
}

TEST(Renderer, makes_no_frame_once_cancelled) {
  Context context;
  const Scene scene = built_in("primitives");
  Renderer renderer(scene, place(scene, small_quilt()), {}, context);
  context.cancelled = true;
  EXPECT_FALSE(renderer.frame(0).has_value());
}

}  // namespace
}  // namespace lippmann
