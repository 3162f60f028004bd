#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "align/align_module_file.hpp"
#include "cli/tool.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

/// Returns the lippmann commands in the page's code blocks, without comments.
Words commands_of(const std::string& page) {
  std::ifstream file(fs::path(LIPPMANN_SOURCE) / page);
  Words commands;
  bool in_code = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) in_code = !in_code;
    if (in_code && line.starts_with("lippmann ")) commands.push_back(line.substr(0, line.find("  #")));
  }
  return commands;
}

/// Returns the rest of each line that begins with `word`, without comments.
Words after_word(const fs::path& path, const std::string& word) {
  std::ifstream file(path);
  Words found;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(word)) continue;
    line = line.substr(word.size(), line.find('#') - word.size());
    found.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return found;
}

TEST(Readme, dockerfile_runs_only_its_two_commands) {
  const fs::path root(LIPPMANN_SOURCE);
  Words commands;
  for (const std::string& script : after_word(root / "README.md", "scripts/")) commands.push_back("scripts/" + script);
  EXPECT_EQ(commands.size(), 2u);
  EXPECT_EQ(after_word(root / "Dockerfile", "RUN "), commands);
  for (const std::string& command : commands) EXPECT_TRUE(fs::exists(root / command)) << command;
}

/// Appends --dry-run to a single render command. Other lines may read the rendered files later, so they stay unchanged.
std::string quick(const std::string& line) {
  const bool alone = line.find("&&") == std::string::npos;
  if (!alone || line.find("lippmann render ") != 0) return line;
  return line + " --dry-run";
}

void expect_runs(const TempDir& dir, const std::string& line) {
  const std::string path = "PATH=" + fs::path(LIPPMANN_TOOL).parent_path().string() + ":$PATH; ";
  const RunResult result = run({"sh", "-c", path + line}, {dir.path().string(), 0});
  EXPECT_EQ(result.exit_code, 0) << line << "\n" << result.err;
}

TEST(Readme, commands_run_unchanged) {
  const Words commands = commands_of("README.md") + commands_of("docs/guide/start.md");
  ASSERT_GE(commands.size(), 20u);
  const TempDir dir;
  fs::create_directory_symlink(fs::path(LIPPMANN_SOURCE) / "examples", dir / "examples");
  ASSERT_EQ(run_tool(dir, {"render", "gears", "--frames", "0-1", "--size", "64x48", "--lenses", "8", "-q"}).exit_code, 0);
  for (const std::string& command : commands) {
    if (command.find("/usr/share/doc/tachyon") != std::string::npos && !fs::exists("/usr/share/doc/tachyon/examples/scenes"))
      continue;
    expect_runs(dir, quick(command));
  }
  // In a clone, git ignores this folder.
  EXPECT_EQ(after_word(fs::path(LIPPMANN_SOURCE) / ".gitignore", "/out/"), Words{""});
  for (const auto& entry : fs::directory_iterator(dir.path()))
    if (entry.path().filename() != "examples") EXPECT_EQ(entry.path().filename(), "out");
}

/// Writes the files that the commands of docs/guide/prints.md read.
void make_pictures_of_prints(const TempDir& dir) {
  expect_done(dir, {"render", "teapot", "--optics", "multiview", "--views", "3x1", "--size", "96x24", "--frames", "0",
                    "--layout", "views", "-q", "-o", "made"});
  for (const char* folder : {"views", "photos", "frames"}) {
    fs::create_directories(dir / folder);
    for (const char* view : {"0", "1", "2"})
      fs::copy_file(dir / ("made/frame_0000/view_00" + std::string(view) + ".png"),
                    dir / (std::string(folder) + "/" + view + ".png"));
  }
  std::ofstream(dir / "own.toml") << "kind = \"lenticular-sheet\"\npixels = [90, 40]\ndpi = 90\nview_cone_deg = 40\n"
                                     "[lenses]\nlenses_per_inch = 9.3\n";
  std::ofstream(dir / "visual.json")
      << R"({"configVersion": "1.0", "serial": "LKG", "pitch": {"value": 52.6}, "slope": {"value": -7.1},
    "center": {"value": 0.8}, "viewCone": {"value": 40}, "invView": {"value": 1}, "DPI": {"value": 324},
    "screenW": {"value": 1536}, "screenH": {"value": 2048}, "flipImageX": {"value": 0}})";
}

/// Writes three views, a stereo pair and a picture with a depth map for docs/guide/prints.md.
void make_textured_pictures(const TempDir& dir) {
  expect_done(dir, {"render", "room", "--optics", "multiview", "--views", "3x1", "--size", "2040x480", "--view-angle", "4",
                    "--frames", "0", "--layout", "views", "-q", "-o", "textured"});
  fs::copy(dir / "textured/frame_0000", dir / "shots");
  expect_done(dir, {"convert", "shots", "pair.png", "--from", "views", "--to", "stereo", "--keep", "0-1", "-q"});
  fs::copy_file(dir / "shots/view_001.png", dir / "photo.png");
  Image8 depth{17, 12, {}};
  for (int i = 0; i < 17 * 12; ++i) depth.rgb.insert(depth.rgb.end(), 3, static_cast<unsigned char>(i));
  write_picture(dir / "depth.png", depth);
}

bool needs_align_module(const std::string& command) {
  return command.find(" align ") != std::string::npos || command.find("aligned") != std::string::npos ||
         command.find("pair_2x1") != std::string::npos;
}

TEST(Docs, commands_of_prints_run) {
  const TempDir dir;
  make_pictures_of_prints(dir);
  make_textured_pictures(dir);
  const Words commands = commands_of("docs/guide/prints.md");
  ASSERT_GE(commands.size(), 6u);
  for (const std::string& command : commands)
    if (is_align_module_installed() || !needs_align_module(command)) expect_runs(dir, command);
}

void make_files_of_the_guide(const TempDir& dir) {
  const fs::path examples = fs::path(LIPPMANN_SOURCE) / "examples";
  fs::create_directory_symlink(examples, dir / "examples");
  fs::copy_file(examples / "desk.glb", dir / "chair.glb");
  make_pictures_of_prints(dir);
  std::ofstream(dir / "own.toml") << "kind = \"slanted-panel\"\npixels = [1536, 2048]\ndpi = 324\nview_cone_deg = 40\n"
                                     "crosstalk = 0.3\n[calibration]\npitch = 52.6\nslope = -7.1\ncenter = 0.8\n";
  std::ofstream(dir / "film.toml") << "scene = \"teapot\"\nframes = \"0-1\"\nsize = \"32x24\"\nlenses = 4\noutput = \"film\"\n";
  std::ofstream(dir / "sky.hdr") << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x40\x40\x40\x81\x40\x40\x40\x81";
}

void make_renders_of_the_guide(const TempDir& dir) {
  const Words small{"--size", "256x256", "--lenses", "32", "--frames", "40", "-q"};
  expect_done(dir, Words{"render", "room", "-o", "out/room"} + small);
  expect_done(dir, Words{"render", "room", "-o", "recorded"} + small);
  expect_done(dir, Words{"render", "teapot", "-o", "out/teapot"} + small);
  expect_done(dir, {"render", "film.toml", "-q"});
  expect_done(dir, {"render", "teapot", "--frames", "3", "--size", "32x24", "--lenses", "4", "-q", "-o", "still"});
  expect_done(dir, {"render", "chair.glb", "--frames", "0-1", "--size", "32x32", "--optics", "single", "--spp", "1", "-q", "-o",
                    "clip"});
  expect_done(dir, {"render", "teapot", "--optics", "multiview", "--views", "8x6", "--size", "240x240", "--frames", "0",
                    "--layout", "quilt", "-q", "-o", "quilt"});
  for (const auto& file : fs::directory_iterator(dir / "quilt"))
    if (file.path().extension() == ".png") fs::copy_file(file.path(), dir / "quilt_qs8x6a0.75.png");
}

bool is_server(const std::string& command) {
  return command.starts_with("lippmann play") ||
         (command.starts_with("lippmann view") && command.find("--save") == std::string::npos);
}

TEST(Docs, commands_of_the_guide_run) {
  const TempDir dir;
  make_files_of_the_guide(dir);
  Words renders, others;
  for (const char* page : {"displays", "light", "many-machines", "replay", "reuse", "scenes", "view"})
    for (const std::string& command : commands_of(fmt::format("docs/guide/{}.md", page)))
      if (!is_server(command)) (command.starts_with("lippmann render") ? renders : others).push_back(command);
  ASSERT_GE(renders.size(), 20u);
  ASSERT_GE(others.size(), 15u);
  for (const std::string& command : renders)
    expect_runs(dir, command.find("--dry-run") != std::string::npos ? command : quick(command));
  make_renders_of_the_guide(dir);
  for (const std::string& command : others)
    expect_runs(dir, "HOME=.; " + command + (command.starts_with("lippmann plan") ? " --only-list" : ""));
}

std::vector<std::string> hard_words_in(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  std::vector<std::string> found;
  for (const char* words :
       {" likewise", " dear ", "tell all about", "tells all about", "that no flag says", "is none of its", "to be looked at"})
    if (text.find(words) != std::string::npos) found.emplace_back(words);
  return found;
}

std::vector<std::string> broken_links_in(const fs::path& page) {
  std::vector<std::string> broken;
  const std::string text = bytes_of(page);
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
    const std::string link = text.substr(at + 2, text.find_first_of(")#", at + 2) - at - 2);
    const bool is_outside = link.empty() || link.find("://") != std::string::npos || link.find(' ') != std::string::npos;
    if (!is_outside && !fs::exists(page.parent_path() / link)) broken.push_back(link);
  }
  return broken;
}

TEST(Docs, links_lead_to_files) {
  const fs::path source(LIPPMANN_SOURCE);
  std::vector<fs::path> pages{source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  ASSERT_GT(pages.size(), 20u);
  for (const fs::path& page : pages) EXPECT_THAT(broken_links_in(page), testing::IsEmpty()) << page;
}

TEST(Docs, command_line_page_equals_the_help) {
  const TempDir dir;
  EXPECT_TRUE(run_tool(dir, {"manual", "--markdown"}).out ==
              bytes_of(fs::path(LIPPMANN_SOURCE) / "docs/reference/command-line.md"))
      << "run: build/release/lippmann manual --markdown > docs/reference/command-line.md";
}

TEST(Docs, pages_are_plain) {
  const fs::path source(LIPPMANN_SOURCE);
  EXPECT_THAT(hard_words_in(bytes_of(source / "README.md")), testing::IsEmpty());
  for (const char* part : {"docs/guide", "docs/reference", "docs/develop"})
    for (const auto& page : fs::recursive_directory_iterator(source / part)) {
      if (!page.is_regular_file()) continue;
      EXPECT_THAT(hard_words_in(bytes_of(page.path())), testing::IsEmpty()) << page.path();
    }
}

TEST(Docs, help_texts_are_plain) {
  const TempDir dir;
  for (const char* command :
       {"render", "check", "compare", "convert", "encode", "replay", "info", "scenes", "displays", "sheet"}) {
    const Words help = command == std::string("render") ? Words{"--help-all"} : Words{"--help"};
    EXPECT_THAT(hard_words_in(run_tool(dir, Words{command} + help).out), testing::IsEmpty()) << command;
  }
}

TEST(Readme, examples_equal_their_generators_output) {
  const TempDir dir;
  fs::copy_file(fs::path(LIPPMANN_SOURCE) / "examples/make_examples.py", dir / "make_examples.py");
  const RunResult made = run({"python3", (dir / "make_examples.py").string()});
  if (made.exit_code == 127) GTEST_SKIP() << "python3 is not installed";
  ASSERT_EQ(made.exit_code, 0) << made.err;
  // desk.glb contains compressed pictures, whose bytes depend on the version of zlib. So only its description is
  // compared.
  EXPECT_EQ(bytes_of(dir / "vase.ply"), bytes_of(fs::path(LIPPMANN_SOURCE) / "examples/vase.ply"));
  for (const char* key : {"meshes", "materials", "triangles"})
    EXPECT_EQ(report_of(dir, {"info", "desk.glb"})[key],
              report_of(dir, {"info", (fs::path(LIPPMANN_SOURCE) / "examples/desk.glb").string()})[key])
        << key;
}

}  // namespace
}  // namespace lippmann::test
