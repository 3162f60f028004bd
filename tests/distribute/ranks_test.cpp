#include "distribute/ranks.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace lippmann {
namespace {

TEST(Ranks, single_process_has_none) {
  unsetenv("OMPI_COMM_WORLD_SIZE"), unsetenv("PMI_SIZE");
  EXPECT_EQ(rank_count(), 1);
  EXPECT_EQ(join_ranks(), nullptr);
}

TEST(Ranks, launcher_states_the_number_of_processes) {
  setenv("OMPI_COMM_WORLD_SIZE", "4", 1), setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "2", 1);
  EXPECT_EQ(rank_count(), 4);
  EXPECT_EQ(local_rank_count(), 2);
  for (const char* text : {"0", "-3", "many", ""}) {
    setenv("OMPI_COMM_WORLD_SIZE", text, 1);
    EXPECT_EQ(rank_count(), 1) << text;
  }
  unsetenv("OMPI_COMM_WORLD_SIZE"), unsetenv("OMPI_COMM_WORLD_LOCAL_SIZE");
}

TEST(Ranks, threads_follow_the_binding_or_share) {
  EXPECT_EQ(threads_of_rank(4, 16, 4), 4);
  EXPECT_EQ(threads_of_rank(16, 16, 4), 4);
  EXPECT_EQ(threads_of_rank(16, 16, 1), 16);
  EXPECT_EQ(threads_of_rank(2, 2, 8), 1);
}

}  // namespace
}  // namespace lippmann
