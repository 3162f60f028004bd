// One simulated life of a job: it is planned, its units are rendered by processes that are killed, on machines that fail, and
// it is finally finished. The folder, the journal and finish are the real code; frames are a few bytes.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann::test {

struct Story {
  std::string problem;  ///< a wrong or lost frame, a folder that cannot be finished ...; empty on success
  std::string log;      ///< events, for people
  int frames = 0, runs = 0;
  std::uint64_t calls = 0;  ///< number of system calls
};

Story tell_story(std::uint64_t seed);

}  // namespace lippmann::test
