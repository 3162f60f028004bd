// Some rows of a film must have the same bits as in the whole film.
#include <gtest/gtest.h>

#include "trace/small_scene.hpp"
#include "trace/strip_order.hpp"
#include "trace/trace_pixels.hpp"

namespace lippmann {
namespace {

using namespace test;

class TraceRows : public testing::TestWithParam<RayOrder> {
 protected:
  TraceRows() : device_(scene_, pool_) {
    device_.update(evaluate(scene_, 0.4), pool_);
    params_.order = GetParam();
    params_.max_depth = scene_.max_depth;
    params_.spp = 2;
  }

  Shot shot(FilmRows rows = {}) const { return {device_, optics_, {}, rows}; }

  Image film(FilmRows rows = {}) const {
    Image film;
    trace_frame(shot(rows), params_, {pool_, context_}, {film});
    return film;
  }

  FrameAovs first_hits(FilmRows rows = {}) const {
    FrameAovs aovs;
    aovs.want(Aov::kDepth), aovs.want(Aov::kNormal);
    find_first_hits(shot(rows), params_.order, nullptr, pool_, aovs);
    return aovs;
  }

  static void expect_rows_of(const Image& whole, FilmRows rows, const Image& part) {
    ASSERT_EQ(part.height, std::min(rows.end, whole.height) - rows.first);
    const std::size_t row = static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.channels);
    for (std::size_t i = 0; i < part.data.size(); ++i)
      ASSERT_EQ(part.data[i], whole.data[static_cast<std::size_t>(rows.first) * row + i]) << i;
  }

  Scene scene_ = busy_scene(11).scene;
  Optics optics_ = single_view(70);
  ThreadPool pool_{2};
  Context context_;
  DeviceScene device_;
  TraceParams params_;
};

TEST_P(TraceRows, equal_those_of_the_whole_film) {
  const int together = rows_per_strip(optics_);
  ASSERT_LT(3 * together, 70);
  const Image whole = film();
  const FrameAovs hits = first_hits();
  for (const FilmRows rows : {FilmRows{0, together}, FilmRows{together, 3 * together}, FilmRows{3 * together}}) {
    expect_rows_of(whole, rows, film(rows));
    const FrameAovs some = first_hits(rows);
    for (const Aov aov : {Aov::kDepth, Aov::kNormal}) expect_rows_of(hits[aov], rows, some[aov]);
  }
}

TEST_P(TraceRows, single_pixels_equal_the_whole_film) {
  const FilmRows rows{2 * rows_per_strip(optics_)};
  Image some = film(rows);
  const Image traced = some;
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t pixel = 3; pixel < 70 * 20; pixel += 7) {
    pixels.push_back(pixel);
    std::fill_n(some.data.begin() + 3 * pixel, 3, -1.0f);
  }
  trace_pixels(shot(rows), params_, pixels, {pool_, context_}, some);
  for (const std::uint32_t pixel : pixels)
    for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(some.data[3 * pixel + c], traced.data[3 * pixel + c], 1e-4f) << pixel;
}

INSTANTIATE_TEST_SUITE_P(Orders, TraceRows, testing::Values(RayOrder::kRows, RayOrder::kColumns, RayOrder::kViewTiles));

}  // namespace
}  // namespace lippmann
