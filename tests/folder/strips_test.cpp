#include "folder/strips.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <fstream>
#include <limits>

#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

FramePictures pictures_of(int width, int rows) {
  FramePictures pictures;
  pictures.film = Image(width, rows, 3);
  const auto fill = [](Image& image) {
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = 1.0f / static_cast<float>(i + 3);
    image.data[5] = std::numeric_limits<float>::infinity();
  };
  fill(pictures.film);
  for (std::size_t i = 0; i < kAovs; ++i) {
    pictures.aovs.want(static_cast<Aov>(i));
    pictures.aovs.allocate(static_cast<Aov>(i), {width, rows});
    fill(pictures.aovs.images[i]);
  }
  return pictures;
}

Image rows_of(const Image& image, int first, int rows) {
  Image part(image.width, rows, image.channels);
  const auto row = static_cast<std::ptrdiff_t>(image.width * image.channels);
  std::copy_n(image.data.begin() + first * row, rows * row, part.data.begin());
  return part;
}

FramePictures rows_of(const FramePictures& whole, int first, int rows) {
  FramePictures part = whole;
  part.film = rows_of(whole.film, first, rows);
  for (Image& image : part.aovs.images) image = rows_of(image, first, rows);
  return part;
}

bool has_same_bits(const Image& a, const Image& b) {
  return a.data.size() == b.data.size() && std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(float)) == 0;
}

TEST(Strips, round_trip_bit_for_bit) {
  const test::TempDir dir;
  const FramePictures whole = pictures_of(7, 10);
  FramePictures joined = pictures_of(7, 10);
  for (Image& image : joined.aovs.images) std::fill(image.data.begin(), image.data.end(), -1.0f);
  std::fill(joined.film.data.begin(), joined.film.data.end(), -1.0f);
  const int begin[] = {0, 4, 10};
  for (int strip = 0; strip < 2; ++strip) {
    const int rows = begin[strip + 1] - begin[strip];
    const FileRecords files = write_strip(dir.path(), 3, strip, rows_of(whole, begin[strip], rows));
    EXPECT_EQ(files.begin()->first, strip_name(3, strip));
    read_strip(dir / strip_name(3, strip), begin[strip], rows, joined);
  }
  EXPECT_TRUE(has_same_bits(joined.film, whole.film));
  for (std::size_t i = 0; i < kAovs; ++i)
    EXPECT_TRUE(has_same_bits(joined.aovs.images[i], whole.aovs.images[i])) << kAovNames[i];
  remove_strips(dir.path(), 3, 2);
  EXPECT_TRUE(std::filesystem::is_empty(dir.path()));
}

TEST(Strips, of_other_rows_or_width_are_refused) {
  const test::TempDir dir;
  write_strip(dir.path(), 0, 0, pictures_of(7, 4));
  FramePictures film = pictures_of(7, 10), wider = pictures_of(8, 10);
  const std::filesystem::path file = dir / strip_name(0, 0);
  EXPECT_THAT(test::error_message([&] { read_strip(file, 0, 5, film); }), HasSubstr("has 7x4 pixels"));
  EXPECT_THAT(test::error_message([&] { read_strip(file, 7, 4, film); }), HasSubstr("has 7x4 pixels"));
  EXPECT_THAT(test::error_message([&] { read_strip(file, 0, 4, wider); }), HasSubstr("has 7x4 pixels"));
}

class StripJournal : public testing::Test {
 protected:
  FolderJournal journal_of(const std::string& lines) const {
    std::filesystem::create_directory(journal_folder(dir_.path()));
    std::ofstream(journal_folder(dir_.path()) / "1.jsonl") << job_line("job") << asked_line({3}) << lines;
    return read_journal(dir_.path()).value();
  }

  std::string line(int strip, int count, const FileRecords& files) const {
    FrameReport report;
    report.frame = 3, report.rays.primary = 50;
    return strip_line({3, strip, count}, report, files);
  }

  test::TempDir dir_;
  const FileChecksum sum_{7, "0123456789abcdef"};
};

TEST_F(StripJournal, changed_files_are_unfinished) {
  const FileRecords files = write_strip(dir_.path(), 3, 1, pictures_of(7, 4));
  const FolderJournal journal = journal_of(line(1, 8, files) + run_line({.host = "a", .strips = {{3, {1}}}}));
  EXPECT_EQ(journal.problem, "");
  EXPECT_EQ(journal.strips.at(3).count, 8);
  EXPECT_EQ(journal.runs.at(0).strips.at(3), std::vector{1});
  EXPECT_EQ(find_strip(dir_.path(), journal, 3, 1)->rays.primary, 50u);
  EXPECT_FALSE(find_strip(dir_.path(), journal, 3, 0));
  EXPECT_FALSE(find_strip(dir_.path(), journal, 4, 1));
  std::ofstream(dir_ / strip_name(3, 1)) << "other";
  EXPECT_FALSE(find_strip(dir_.path(), journal, 3, 1));
}

TEST_F(StripJournal, impossible_numbers_and_names_are_problems) {
  const FileRecords own{{strip_name(3, 1), sum_}}, picture{{"frame_0003.png", sum_}}, other{{strip_name(3, 2), sum_}};
  EXPECT_EQ(journal_of(line(1, 8, own)).problem, "");
  for (const std::string& bad : {line(8, 8, own), line(-1, 8, own), line(1, 5000, own), line(1, 8, picture), line(1, 8, other),
                                 line(1, 8, own) + line(2, 9, other)})
    EXPECT_NE(journal_of(bad).problem, "") << bad;
}

TEST(StripNames, belong_to_a_frame_but_are_not_pictures) {
  EXPECT_EQ(strip_name(3, 12), "strip_0003_012.exr");
  EXPECT_EQ(frame_of_file("strip_0003_012.exr"), 3);
  EXPECT_TRUE(is_strip_name("strip_0003_012.exr"));
  for (const char* name : {"frame_0003.png", "strip_0003.exr", "strip_0003_012.png", "a/strip_0003_012.exr"})
    EXPECT_FALSE(is_strip_name(name)) << name;
}

}  // namespace
}  // namespace lippmann
