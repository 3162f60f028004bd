#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/compare.hpp"
#include "core/npy.hpp"
#include "core/regular_file.hpp"
#include "image/netpbm.hpp"
#include "job/renders.hpp"
#include "job/report.hpp"
#include "lippmann/core/version.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "replay/replay.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

class LightFieldRenders : public Renders {};

const Settings kGrid{{"optics", "multiview"}, {"camera-grid", "true"}, {"views", "2x2"}, {"size", "32x32"}, {"frames", "0-1"}};

TEST_F(LightFieldRenders, formats_equal_conversion_of_the_render) {
  render(job("teapot", "film", kGrid + Settings{{"aov", "depth"}}));
  for (const std::string format :
       {"hci", "stanford", "jpeg-pleno", "miv", "nerf", "colmap", "eslf", "views", "integral", "quilt", "cvkit", "lytro"}) {
    convert("film", "converted-" + format, format);
    render(job("teapot", format, kGrid + Settings{{"to", format}}));
    Files converted = pictures_below(dir_ / ("converted-" + format));
    std::erase_if(converted, [](const auto& file) { return file.first.ends_with("views.json"); });  // report.json of renders
    EXPECT_FALSE(converted.empty());
    Files made = pictures_below(dir_ / format);
    std::erase_if(made, [](const auto& file) { return !file.first.starts_with("frame_"); });
    EXPECT_EQ(made, converted) << format;
    EXPECT_TRUE(check(format).passed());
    const LightFieldHints hints{.from = format};
    EXPECT_EQ(replay({.in = dir_ / format, .field = hints, .folder = dir_ / "eye"}, context_).written.size(), 2u) << format;
  }
}

TEST_F(LightFieldRenders, binary_colmap_equals_conversion) {
  render(job("teapot", "film", kGrid + Settings{{"aov", "depth"}}));
  const LightFieldFormat& colmap = find_format("colmap", "to");
  colmap.write(open_light_field(dir_ / "film/frame_0001.png", "", {.with_depth = true}).field, dir_ / "converted",
               {.binary = true});
  render(job("teapot", "made", kGrid + Settings{{"to", "colmap"}, {"binary", "true"}}));
  for (const char* name : {"cameras.bin", "images.bin", "points3D.bin"})
    EXPECT_EQ(bytes(std::string("made/frame_0001/sparse/0/") + name), bytes(std::string("converted/sparse/0/") + name)) << name;
  EXPECT_FALSE(exists("made/frame_0001/sparse/0/cameras.txt"));
}

TEST_F(LightFieldRenders, formats_keep_light_and_16_bits) {
  render(job("teapot", "film", kGrid + Settings{{"aov", "depth"}, {"format", "png16"}, {"layout", "views"}}));
  convert("film", "converted", "hci");
  render(job("teapot", "png16", kGrid + Settings{{"to", "hci"}, {"format", "png16"}}));
  EXPECT_EQ(pictures_below(dir_ / "png16"), pictures_below(dir_ / "converted"));
  render(job("teapot", "exr", kGrid + Settings{{"to", "hci"}, {"format", "exr"}}));
  EXPECT_TRUE(exists("exr/frame_0001/input_Cam003.exr"));
}

TEST_F(LightFieldRenders, damaged_side_files_are_written_again) {
  const RenderParams params = job("teapot", "a", kGrid + Settings{{"to", "hci"}});
  render(params);
  const Files whole = pictures_below(dir_ / "a");
  fs::remove(dir_ / "a/frame_0001/parameters.cfg");
  std::ofstream(dir_ / "a/frame_0000/gt_disp_lowres_Cam001.pfm") << "damaged";
  const FolderCheck found = check("a");
  EXPECT_THAT(found.damaged, testing::ElementsAre("frame_0000/gt_disp_lowres_Cam001.pfm"));
  EXPECT_THAT(found.missing, testing::ElementsAre("frame_0001/parameters.cfg"));
  resume(params);
  EXPECT_EQ(pictures_below(dir_ / "a"), whole);
}

void expect_same_depth(const fs::path& one, const fs::path& other) {
  const Image a = read_pfm(one), b = read_pfm(other);
  for (std::size_t i = 0; i < a.data.size(); ++i)
    if (!std::isinf(a.data[i])) {
      ASSERT_NEAR(a.data[i], b.data[i], 1e-4) << one;
    }
}

TEST_F(LightFieldRenders, data_set_restores_pictures_and_depth) {
  render(job("teapot", "r",
             {{"optics", "multiview"},
              {"camera-grid", "true"},
              {"views", "3x3"},
              {"size", "96x72"},
              {"frames", "0"},
              {"view-angle", "1.5"},
              {"aov", "depth"},
              {"format", "png16"}}));
  convert("r/frame_0000.png", "hci", "hci");
  ConvertParams again;
  again.from = "hci", again.keep = read_kept_views("0-2x0-2", "keep");
  convert("hci", "again", "hci", again);
  EXPECT_EQ(files_in(dir_ / "hci", ".png").size(), 9u);
  EXPECT_EQ(files_in(dir_ / "hci", ".png"), files_in(dir_ / "again", ".png"));
  EXPECT_FALSE(files_in(dir_ / "hci", ".pfm").empty());
  for (const auto& [name, depth] : files_in(dir_ / "hci", ".pfm"))
    expect_same_depth(dir_ / "hci" / name, dir_ / "again" / name);
}

TEST_F(LightFieldRenders, walls_parallel_to_the_views_have_constant_z) {
  std::ofstream(dir_ / "wall.nff")
      << "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0.1\nresolution 32 32\nb 0 0 0\nl 0 3 5\n"
         "f 0.8 0.8 0.8 1 0 0 0 0\np 4\n-9 -9 -1\n9 -9 -1\n9 9 -1\n-9 9 -1\n";
  render(job((dir_ / "wall.nff").string(), "wall", kGrid + Settings{{"to", "nerf"}, {"frames", "0"}}));
  const auto json = nlohmann::json::parse(bytes("wall/frame_0000/transforms.json"));
  const auto array = [&](const std::string& name) {
    return parse_npy(read_file_bytes(dir_ / "wall/frame_0000" / name, 1 << 20), name).values;
  };
  for (const auto& frame : json["frames"]) {
    const std::vector<double> z = array(frame["depth_file_path"]), rays = array(frame["ray_length_file_path"]);
    ASSERT_EQ(z.size(), 16u * 16u);
    for (std::size_t i = 0; i < z.size(); ++i) {
      EXPECT_NEAR(z[i], z[0], 1e-5 * z[0]);
      const double x = (static_cast<double>(i % 16) + 0.5 - frame["cx"].get<double>()) / frame["fl_x"].get<double>();
      const double y = (static_cast<double>(i / 16) + 0.5 - frame["cy"].get<double>()) / frame["fl_y"].get<double>();
      EXPECT_NEAR(rays[i], z[0] / std::cos(std::atan(std::hypot(x, y))), 1e-5 * z[0]);
    }
  }
}

TEST_F(LightFieldRenders, quilt_survives_a_round_trip) {
  std::ofstream(dir_ / "visual.json") << R"({"serial": "DIY", "pitch": {"value": 20}, "slope": {"value": -5.5},
    "center": {"value": 0.2}, "DPI": 100, "screenW": 120, "screenH": 160})";
  render(job("room", "quilt",
             {{"optics", "multiview"}, {"views", "4x2"}, {"size", "240x160"}, {"frames", "0"}, {"layout", "quilt"}}));
  ConvertParams params;
  params.options.display = load_display(dir_ / "visual.json");
  params.from = "quilt";
  convert("quilt/" + files_in(dir_ / "quilt", ".png").begin()->first, "panel.png", "native", params);
  params.from = "native", params.options.views = ViewGrid{8, 1};
  convert("panel.png", "views", "views", params);
  EXPECT_EQ(files_in(dir_ / "views", ".png").size(), 8u);
  params.from = "views";
  convert("views", "again.png", "native", params);
  EXPECT_TRUE(compare(dir_ / "panel.png", dir_ / "again.png", context_).identical);
}

TEST_F(LightFieldRenders, exr_header_has_version_optics_and_views) {
  const auto report = to_json(render(teapot("a", "0", {{"format", "exr"}})));
  render(teapot("b", "0", {{"aov", "depth"}}));
  for (const char* file : {"a/frame_0000.exr", "b/aov_0000.exr"}) {
    const Imf::InputFile exr((dir_ / file).c_str());
    const auto text = [&](const char* name) {
      const auto* attribute = exr.header().findTypedAttribute<Imf::StringAttribute>(name);
      return attribute ? attribute->value() : std::string();
    };
    EXPECT_EQ(text("lippmann.version"), version()) << file;
    EXPECT_EQ(text("lippmann.scene"), "teapot") << file;
    EXPECT_EQ(text("lippmann.views"), "8x1") << file;
    EXPECT_EQ(nlohmann::ordered_json::parse(text("lippmann.optics")), report["optics"]) << file;
    EXPECT_LT(report["depth"]["scale"], 1.0) << "this test needs a scene whose depth is scaled";
    EXPECT_NEAR(std::stod(text("lippmann.depth_scale")), report["depth"]["scale"].get<double>(), 1e-6) << file;
  }
}

}  // namespace
}  // namespace lippmann::test
