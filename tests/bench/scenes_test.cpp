#include "bench/scenes.hpp"

#include <gtest/gtest.h>

#include "bench/light_rows.hpp"

namespace lippmann::bench {
namespace {

TEST(BenchmarkScenes, have_their_full_depth) {
  const Request request;
  const Context context;
  for (const BenchScene& scene : bench_scenes(request, context)) EXPECT_EQ(scene.params.optics.fit_depth, false) << scene.name;
  for (const BenchAnimation& animation : bench_animations(request, context))
    EXPECT_EQ(animation.params.optics.fit_depth, false) << animation.name;
  for (const BenchScene& scene : tachyon_scenes(request)) EXPECT_EQ(scene.params.optics.fit_depth, false) << scene.name;
  for (const LightCase& row : light_cases(request, context)) EXPECT_EQ(row.params.optics.fit_depth, false) << row.name;
}

}  // namespace
}  // namespace lippmann::bench
