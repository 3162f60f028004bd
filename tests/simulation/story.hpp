// One simulated life of a job: it is planned, its units are rendered by processes that are killed, on machines that fail, and
// it is finished in the end. The folder, the journal and finish are the real code; frames are a few bytes.
#pragma once

#include <cstdint>
#include <string>

namespace lippmann::test {

struct Story {
  std::string problem;  ///< a wrong or lost frame, a folder that cannot be finished ...; empty: all went well
  std::string log;      ///< what happened, for people
  int frames = 0, runs = 0;
  std::uint64_t calls = 0;  ///< how often the system has been called
};

Story tell_story(std::uint64_t seed);

}  // namespace lippmann::test
