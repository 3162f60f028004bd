// A failed write at any position must throw an Error and leave no file.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <functional>
#include <iterator>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/image.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using Write = std::function<void(const std::filesystem::path&)>;

class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

bool fails(const Write& write, const std::filesystem::path& path, rlim_t limit) {
  const FileSizeLimit full(limit);
  try {
    write(path);
  } catch (const Error&) {
    return true;
  }
  return false;
}

void expect_error_and_no_file_for_every_limit(const Write& write) {
  const test::TempDir dir;
  write(dir / "whole");
  const std::uintmax_t bytes = std::filesystem::file_size(dir / "whole");
  for (std::uintmax_t limit = 0; limit < bytes; limit = limit + 16 < bytes ? limit + 1 + bytes / 50 : limit + 1) {
    EXPECT_TRUE(fails(write, dir / "cut", limit)) << limit << " of " << bytes << " bytes";
    EXPECT_FALSE(std::filesystem::exists(dir / "cut")) << limit;
  }
  const std::filesystem::directory_iterator files(dir.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "no temporary file stays";
}

Image8 noise() {
  Image8 image{40, 70, {}};
  std::uint32_t state = 1;
  for (int i = 0; i < 40 * 70 * 3; ++i)
    image.rgb.push_back(static_cast<unsigned char>((state = state * 1664525u + 1013904223u) >> 24));
  return image;
}

TEST(FullDisk, png_fails_without_leaving_a_file) {
  expect_error_and_no_file_for_every_limit([](const auto& path) { write_png(path, noise()); });
}

TEST(FullDisk, tiff_fails_without_leaving_a_file) {
  for (const TiffKind kind : {TiffKind::kAuto, TiffKind::kBig})
    expect_error_and_no_file_for_every_limit([&](const auto& path) { write_tiff(path, noise(), {10.0, kind}); });
}

TEST(FullDisk, exr_fails_without_leaving_a_file) {
  Image film(40, 70, 3);
  const Image8 codes = noise();
  std::copy(codes.rgb.begin(), codes.rgb.end(), film.data.begin());
  const std::array<ExrLayer, 1> layers{film_layer(film, ExrSample::kFloat)};
  expect_error_and_no_file_for_every_limit([&](const auto& path) { write_exr(path, layers); });
}

}  // namespace
}  // namespace lippmann
