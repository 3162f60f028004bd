// Simulates the life of a job: processes that render its parts, killed processes and failing machines. The real code
// handles the output folder. Pictures are a few bytes each.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann::test {

struct Story {
  /// what went wrong, such as a lost frame; empty on success
  std::string problem;
  std::string log;
  int frames = 0, runs = 0;
  std::uint64_t calls = 0;
};

Story tell_story(std::uint64_t seed);

}  // namespace lippmann::test
