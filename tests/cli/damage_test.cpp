// Tests that commands that read a render name the damaged file and write nothing.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>

#include "cli/tool.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void flip_a_byte(const fs::path& path, double where = 0.7) {
  std::string bytes = bytes_of(path);
  bytes[static_cast<std::size_t>(where * static_cast<double>(bytes.size()))] ^= 1;
  std::ofstream(path, std::ios::binary) << bytes;
}

void exchange(const fs::path& a, const fs::path& b) {
  const std::string bytes = bytes_of(a);
  fs::copy_file(b, a, fs::copy_options::overwrite_existing);
  std::ofstream(b, std::ios::binary) << bytes;
}

void replace(const fs::path& path, const std::string& text, const std::string& by) {
  std::string bytes = bytes_of(path);
  bytes.replace(bytes.find(text), text.size(), by);
  std::ofstream(path, std::ios::binary) << bytes;
}

struct Damage {
  std::string named;  ///< part of the expected error message
  std::function<void(const fs::path& folder)> make;
};

const std::vector<Words>& readers() {
  static const std::vector<Words> all{
      {"convert", "a", "out", "--to", "views"}, {"replay", "a", "-o", "out"}, {"encode", "a", "out.mkv"},
      {"view", "a", "--save", "out"},           {"compare", "a", "a"},        {"check", "a"}};
  return all;
}

void expect_found(const TempDir& dir, const Damage& damage, const Words& reader) {
  fs::copy(dir / "whole", dir / "a", fs::copy_options::recursive);
  damage.make(dir / "a");
  const RunResult result = run_tool(dir, reader);
  EXPECT_NE(result.exit_code, 0) << reader.front() << ": " << damage.named;
  EXPECT_THAT(result.err + result.out, HasSubstr(damage.named)) << reader.front();
  for (const char* name : {"a", "out", "out.mkv"}) fs::remove_all(dir / name);
}

TEST(Damage, frames_and_journals_are_checked) {
  const TempDir dir;
  expect_done(dir, {"render", "teapot", "--optics", "multiview", "--views", "2x2", "--size", "32x32", "--layout", "quilt",
                    "--frames", "0-2", "-o", "whole"});
  const std::string first = "frame_0000_qs2x2a1.png", second = "frame_0001_qs2x2a1.png";
  // Either of the exchanged files may be named first, so only the common part of their names is expected.
  const std::vector<Damage> damages{{"qs2x2a1.png", [&](const fs::path& a) { exchange(a / first, a / second); }},
                                    {second, [&](const fs::path& a) { fs::remove(a / second); }},
                                    {"jsonl", [](const fs::path& a) {
                                       for (const auto& part : fs::directory_iterator(a / ".lippmann"))
                                         std::ofstream(part.path(), std::ios::app) << std::string(1000, 'x');
                                     }}};
  for (const Damage& damage : damages)
    for (const Words& reader : readers()) expect_found(dir, damage, reader);
  for (const Words& reader : readers())
    if (reader.front() != "compare")
      expect_found(
          dir,
          {"report.json", [](const fs::path& a) { replace(a / "report.json", "\"distance_mm\": ", "\"distance_mm\": 1"); }},
          reader);
}

TEST(Damage, one_changed_byte_is_found) {
  const TempDir dir;
  for (const std::string format : {"exr", "tiff", "png16"}) {
    expect_done(dir, small_teapot("0", "whole") + Words{"--format", format, "--aov", "depth"});
    const std::string name = format == "exr" ? "frame_0000.exr" : format == "tiff" ? "frame_0000.tif" : "frame_0000.png";
    const Damage damage{name, [&](const fs::path& a) { flip_a_byte(a / name); }};
    for (const Words& reader : readers()) expect_found(dir, damage, reader);
    if (format != "exr")
      expect_found(dir, {"aov_0000.exr", [](const fs::path& a) { flip_a_byte(a / "aov_0000.exr"); }},
                   {"convert", "a", "out", "--to", "hci"});
    fs::remove_all(dir / "whole");
  }
}

TEST(Damage, damaged_depth_and_cameras_are_found) {
  const TempDir dir;
  expect_done(dir, {"render", "teapot", "--optics", "multiview", "--views", "2x2", "--size", "32x32", "--camera-grid", "--to",
                    "hci", "--frames", "0", "-o", "whole"});
  const std::vector<std::pair<std::string, std::string>> files_and_formats{{"frame_0000/gt_depth_lowres_Cam000.pfm", "rgbd"},
                                                                           {"frame_0000/parameters.cfg", "views"}};
  for (const auto& [name, format] : files_and_formats)
    expect_found(dir, {name, [&, &file = name](const fs::path& a) { flip_a_byte(a / file); }},
                 {"convert", "a", "out", "--to", format});
}

TEST(Damage, missing_journal_is_reported_as_unchecked) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  EXPECT_EQ(run_tool(dir, {"convert", "a", "b", "--to", "views", "--quiet"}).err, "");
  fs::remove_all(dir / "a/.lippmann");
  for (const Words& reader : readers()) {
    if (reader.front() == "check") continue;
    const RunResult result = run_tool(dir, reader);
    EXPECT_EQ(result.exit_code, 0) << reader.front() << result.err;
    EXPECT_THAT(result.err, HasSubstr("not checked for damage")) << reader.front();
  }
}

TEST(Damage, unlisted_frame_is_reported_as_unchecked) {
  const TempDir dir;
  expect_done(dir, small_teapot("0", "a"));
  fs::copy_file(dir / "a/frame_0000.png", dir / "a/frame_0001.png");
  for (const Words& reader : readers()) {
    if (reader.front() == "check") continue;
    EXPECT_THAT(run_tool(dir, reader).err, HasSubstr("it is not checked for damage: frame_0001.png")) << reader.front();
  }
}

TEST(Damage, control_characters_of_names_are_escaped) {
  const TempDir dir;
  const std::string name = "a\x1b[31m";
  expect_done(dir, small_teapot("0", name));
  for (const bool is_whole : {true, false}) {
    if (!is_whole) fs::remove(dir / name / "frame_0000.png");
    for (const char* command : {"finish", "check"}) {
      const RunResult result = run_tool(dir, {command, name});
      EXPECT_THAT(result.out, testing::AllOf(HasSubstr("a?[31m"), testing::Not(HasSubstr("\x1b")))) << command;
    }
  }
}

}  // namespace
}  // namespace lippmann::test
