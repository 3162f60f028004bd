// Benchmarks measure the scenes that they always did, whatever the defaults of a render become.
#include "bench/scenes.hpp"

#include <gtest/gtest.h>

#include "bench/light_rows.hpp"

namespace lippmann::bench {
namespace {

TEST(BenchmarkScenes, have_all_of_their_depth) {
  const Request request;
  const Context context;
  for (const BenchScene& scene : bench_scenes(request, context)) EXPECT_FALSE(fits_depth(scene.params)) << scene.name;
  for (const BenchAnimation& animation : bench_animations(request, context))
    EXPECT_FALSE(fits_depth(animation.params)) << animation.name;
  for (const BenchScene& scene : tachyon_scenes(request)) EXPECT_FALSE(fits_depth(scene.params)) << scene.name;
  for (const LightCase& row : light_cases(request, context)) EXPECT_FALSE(fits_depth(row.params)) << row.name;
}

}  // namespace
}  // namespace lippmann::bench
