#include "bench/paper_summary.hpp"

#include <gmock/gmock.h>

namespace lippmann::bench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The in-between frame has a PSNR of 20 dB and takes `cost` times the time of tracing it.
ReuseRun run_of(const char* scene, int keyframes, double cost, const char* method = "forward") {
  ReuseRun run{scene, method, keyframes, 1, {}};
  ReuseFrame key, between;
  key.key = true, key.traced_seconds = between.traced_seconds = 1.0;
  key.seconds = between.seconds = cost;
  between.likeness.psnr_db = 20.0;
  run.frames = {key, between};
  return run;
}

TEST(PaperSummary, takes_the_shortest_sufficient_interval) {
  // For "primitives", the paper states a saving of 1 - 333 / 1024 = 67.5 %.
  const auto rows = reproduced_figures({run_of("primitives", 2, 0.6), run_of("primitives", 4, 0.3),
                                        run_of("primitives", 8, 0.2), run_of("primitives", 4, 0.1, "forward, halving")});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].keyframes, 4);
  EXPECT_NEAR(rows[0].saving, 0.7, 1e-12);
  EXPECT_EQ(rows[0].verdict(), "yes");
}

TEST(PaperSummary, falls_back_to_the_largest_saving) {
  const auto rows =
      reproduced_figures({run_of("primitives", 2, 0.6), run_of("primitives", 4, 0.5), run_of("primitives", 8, 0.55)});
  EXPECT_EQ(rows[0].keyframes, 4);
  EXPECT_EQ(rows[0].verdict(), "no");
}

TEST(PaperSummary, psnr_counts_where_the_paper_states_one) {
  // The paper states 34.52 dB for the teapot, which is more than the 20 dB of run_of().
  EXPECT_EQ(reproduced_figures({run_of("teapot", 8, 0.1)})[0].verdict(), "no");
  EXPECT_EQ(reproduced_figures({run_of("gears", 8, 0.1)})[0].verdict(), "not in the paper");
}

TEST(PaperSummary, csv_and_text_list_all_scenes) {
  const auto rows = reproduced_figures({run_of("primitives", 4, 0.3), run_of("gears", 8, 0.1)});
  EXPECT_EQ(reproduced_csv(rows),
            "scene,keyframes,saving,paper_saving,psnr_db,paper_psnr_db,reproduced\n"
            "primitives,4,0.7000,0.6748,20.00,,yes\n"
            "gears,8,0.9000,,20.00,,not in the paper\n");
  EXPECT_THAT(reproduced_text(rows), StartsWith("Reproduced: 1 of 1 animations of the paper"));
}

}  // namespace
}  // namespace lippmann::bench
