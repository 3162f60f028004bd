// Simulates the life of a job. The job is planned, processes render its units, processes are killed, machines fail, and finally
// the job is finished. The output folder and its journal are handled by the real code. The pictures are a few bytes each.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann::test {

struct Story {
  /// what went wrong, such as a wrong or lost frame or a folder that cannot be finished; empty on success
  std::string problem;
  std::string log;  ///< list of events, for people to read
  int frames = 0, runs = 0;
  std::uint64_t calls = 0;  ///< number of simulated system calls
};

Story tell_story(std::uint64_t seed);

}  // namespace lippmann::test
