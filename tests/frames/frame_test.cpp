#include "frames/frame.hpp"
#include "job/job_stage.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

RenderParams small_params() {
  RenderParams params;
  params.scene.name = "primitives";
  params.optics.lenses = {4, 4};
  return params;
}

TEST(Stage, of_a_scene_equals_that_of_its_name) {
  const RenderParams params = small_params();
  const Context context;
  const ThreadPool pool(1);
  JobStage named(ResolvedJob(params), pool, context),
      made(load_scene_of(ResolvedJob(params), context), ResolvedJob(params), pool);
  const RenderedFrame of_named = render_frame(named, params.sampling, 3, pool, context);
  const RenderedFrame of_made = render_frame(made, params.sampling, 3, pool, context);
  EXPECT_EQ(of_named.pictures.film.data, of_made.pictures.film.data);
}

TEST(Stage, of_a_scene_without_lights_is_dark) {
  const RenderParams params = small_params();
  const Context context;
  const ThreadPool pool(1);
  Scene scene = load_scene_of(ResolvedJob(params), context).scene;
  scene.lights.clear();
  scene.background = {};
  for (Material& material : scene.materials)
    if (auto* phong = std::get_if<PhongSurface>(&material.surface)) phong->ambient = 0.0f, phong->emission = Vec3f(0.0f);
  JobStage stage({std::move(scene), {}}, ResolvedJob(params), pool);
  const RenderedFrame frame = render_frame(stage, params.sampling, 0, pool, context);
  for (const float value : frame.pictures.film.data) ASSERT_EQ(value, 0.0f);
}

}  // namespace
}  // namespace lippmann
