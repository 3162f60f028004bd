// Damaged video files: whatever their bytes, reading them gives frames or an error, and never ends the process.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "video/video_reader.hpp"
#include "video/video_writer.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;

std::string file_bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void read_to_the_end(const fs::path& path) {
  try {
    VideoReader reader(path);
    while (reader.next()) {}
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace lippmann
