#include "job/params_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;
using Values = std::vector<std::string>;

const std::map<std::string_view, Values> kOtherValues{
    {"scene", {"room"}},
    {"camera-path", {"room.cam"}},
    {"cameras", {"sphere:4"}},
    {"animation", {"Walk"}},
    {"variant", {"Beach"}},
    {"asset-root", {"models"}},
    {"texture-memory", {"4096"}},
    {"points", {"0.25"}},
    {"camera", {"Front"}},
    {"up", {"-z"}},
    {"focus", {"Head"}},
    {"ipd", {"58.5"}},
    {"screen-width", {"700"}},
    {"stereo", {"half-over-under"}},
    {"right-first", {"true"}},
    {"depth-range", {"12.5:-40"}},
    {"binary", {"true"}},
    {"depth-coding", {"depth"}},
    {"near-black", {"true"}},
    {"fit-to", {"Group"}},
    {"zoom", {"1.5"}},
    {"orbit", {"-30,12.5"}},
    {"frames", {"3-7"}},
    {"fps", {"29.97"}},
    {"light-scale", {"0.25"}},
    {"optics", {"microlens"}},
    {"packing", {"hexagonal"}},
    {"lenses", {"32x16"}},
    {"lens-pixels", {"13.776"}},
    {"size", {"640x480"}},
    {"views", {"5x9"}},
    {"view-angle", {"40.5"}},
    {"viewing-distance", {"600"}},
    {"sensor-width", {"23.5"}},
    {"focal-length", {"85"}},
    {"gap", {"0.37"}},
    {"lens-focal-length", {"0.5"}},
    {"slant", {"-9.46"}},
    {"integrator", {"path"}},
    {"clamp-indirect", {"10"}},
    {"exposure", {"-1.5"}},
    {"tone", {"agx"}},
    {"environment", {"sky.hdr"}},
    {"environment-strength", {"0.5"}},
    {"environment-rotation", {"-90"}},
    {"spp", {"16"}},
    {"max-depth", {"3"}},
    {"seed", {"4294967295"}},
    {"order", {"columns"}},
    {"output", {"some/folder"}},
    {"format", {"exr"}},
    {"exr-pixels", {"float"}},
    {"aov", {"depth", "id"}},
    {"video", {"a.mp4", "b.mkv"}},
    {"strips", {"8"}},
    {"threads", {"3"}},
    {"resume", {"true"}},
    {"reuse", {"interpolate"}},
    {"keyframes", {"4"}},
    {"min-psnr", {"45.5"}},
    {"splat", {"lens"}},
    {"fill", {"retrace"}},
    {"no-z-buffer", {"true"}},
    {"debug", {"missed"}},
    {"halving", {"true"}},
    {"layout", {"views"}},
    {"to", {"hci"}},
    {"quilt", {"4x2"}},
    {"camera-grid", {"true"}},
    {"cone-ends", {"true"}},
    {"eye-height", {"-12.5deg"}},
    {"video-codec", {"hevc"}},
    {"crf", {"30"}},
    {"also", {"single"}},
    {"page", {"true"}},
    {"fit-depth", {"true"}},
    {"angular-filter", {"box"}},
    {"aperture", {"4.5"}},
    {"f-number", {"2.8"}},
    {"focal-plane", {"-12"}},
    {"shutter", {"0.5"}},
    {"crosstalk", {"0.4"}},
    {"precompensate", {"true"}},
    {"display", {"portrait"}},
    {"mirror", {"true"}},
    {"pseudoscopic", {"true"}},
    {"transparent", {"true"}},
    {"denoise", {"none"}},
};

const ParamInfo& param(std::string_view name) {
  const ParamInfo* info = find_param(name);
  if (!info) throw std::logic_error("no parameter " + std::string(name));
  return *info;
}

std::string message_of_setting(std::string_view name, const std::string& value) {
  RenderParams params;
  try {
    param(name).set(params, {value}, "--" + std::string(name));
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 2);
    return error.what();
  }
  return "accepted";
}

TEST(ParamsTable, every_parameter_survives_a_round_trip) {
  for (const ParamInfo& info : params_table()) {
    ASSERT_TRUE(kOtherValues.contains(info.name)) << info.name << ": give it a value in this test";
    RenderParams params;
    info.set(params, kOtherValues.at(info.name), "test");
    EXPECT_EQ(info.get(params), kOtherValues.at(info.name)) << info.name;
  }
}

TEST(ParamsTable, former_names_of_reuse_are_read) {
  for (const auto& [former, name] : {std::pair("exact", "auto"), std::pair("forward", "interpolate")}) {
    RenderParams params;
    param("reuse").set(params, {former}, "test");
    EXPECT_EQ(param("reuse").get(params), Values{name});
  }
}

TEST(ParamsTable, boolean_denoise_is_read) {
  for (const auto& [former, name] : {std::pair("true", "auto"), std::pair("false", "none")}) {
    RenderParams params;
    param("denoise").set(params, {former}, "test");
    EXPECT_EQ(param("denoise").get(params), Values{name});
  }
  EXPECT_THAT(message_of_setting("denoise", "yes"), HasSubstr("auto, none"));
}

TEST(ParamsTable, setting_one_parameter_leaves_all_others_alone) {
  const RenderParams defaults;
  for (const ParamInfo& info : params_table()) {
    RenderParams params;
    info.set(params, kOtherValues.at(info.name), "test");
    for (const ParamInfo& other : params_table())
      if (other.name != info.name) {
        EXPECT_EQ(other.get(params), other.get(defaults)) << other.name << " after " << info.name;
      }
  }
}

TEST(ParamsTable, documented_defaults_are_valid) {
  const RenderParams defaults;
  for (const ParamInfo& info : params_table()) {
    const Values values = info.get(defaults);
    if (values.empty()) continue;
    RenderParams params;
    EXPECT_NO_THROW(info.set(params, values, "test")) << info.name;
    EXPECT_EQ(info.get(params), values) << info.name;
  }
}

TEST(ParamsTable, names_are_unique_flags_without_underscores) {
  std::set<std::string_view> names;
  for (const ParamInfo& info : params_table()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(info.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << info.name;
    EXPECT_FALSE(info.doc.empty()) << info.name;
  }
}

TEST(ParamsTable, out_of_range_numbers_name_the_flag) {
  EXPECT_THAT(message_of_setting("spp", "-1"), testing::StartsWith("--spp: "));
  EXPECT_THAT(message_of_setting("spp", "-1"), HasSubstr("from 0 to 65536"));
  EXPECT_THAT(message_of_setting("spp", "many"), HasSubstr("from 0 to 65536"));
  EXPECT_THAT(message_of_setting("spp", "4.5"), HasSubstr("whole number"));
  EXPECT_THAT(message_of_setting("spp", ""), HasSubstr("whole number"));
  EXPECT_THAT(message_of_setting("spp", "99999999999999999999"), HasSubstr("from 0 to 65536"));
  EXPECT_THAT(message_of_setting("view-angle", "nan"), HasSubstr("from 0.1 to 170"));
  EXPECT_THAT(message_of_setting("view-angle", "180"), HasSubstr("from 0.1 to 170"));
  EXPECT_THAT(message_of_setting("seed", "-1"), HasSubstr("from 0 to 4294967295"));
  EXPECT_THAT(message_of_setting("min-psnr", "5"), testing::StartsWith("--min-psnr: "));
  EXPECT_THAT(message_of_setting("min-psnr", "nan"), testing::StartsWith("--min-psnr: "));
  EXPECT_THAT(message_of_setting("keyframes", "1"), testing::StartsWith("--keyframes: "));
}

TEST(ParamsTable, invalid_extents_are_refused) {
  EXPECT_THAT(message_of_setting("size", "0x512"), HasSubstr("from 1 to"));
  EXPECT_THAT(message_of_setting("size", "512x"), HasSubstr("N or NxM"));
  EXPECT_THAT(message_of_setting("size", "512x512x512"), HasSubstr("N or NxM"));
  EXPECT_THAT(message_of_setting("lenses", "0"), HasSubstr("from 1 to"));
  EXPECT_THAT(message_of_setting("lens-pixels", "0.5"), HasSubstr("from 1 to"));
  EXPECT_THAT(message_of_setting("lens-pixels", "inf"), HasSubstr("from 1 to"));
}

TEST(ParamsTable, single_number_leaves_the_other_unset) {
  RenderParams params;
  param("lenses").set(params, {"64"}, "test");
  EXPECT_EQ(params.optics.lenses, (Extent<int>{64, 0}));
  EXPECT_EQ(param("lenses").get(params), Values{"64"});
}

TEST(ParamsTable, frames_are_a_range_or_one) {
  RenderParams params;
  param("frames").set(params, {"5"}, "test");
  EXPECT_EQ(params.output.frames, (FrameRanges{{5, 5}}));
  for (const char* bad : {"7-3", "-1-3", "a-b", "3-", "", "0-4:0", "0-4:", "1,", ",1", "0;2"})
    EXPECT_THAT(message_of_setting("frames", bad), HasSubstr("0 <= A <= B"));
}

TEST(ParamsTable, frames_accept_lists_and_steps) {
  RenderParams params;
  param("frames").set(params, {"20,0-9:3,4,4-5"}, "test");
  EXPECT_EQ(frames_of(*params.output.frames), (std::vector<int>{0, 3, 4, 5, 6, 9, 20}));
  EXPECT_EQ(param("frames").get(params), Values{"20,0-9:3,4,4-5"});
}

TEST(ParamsTable, too_many_frames_are_refused_first) {
  EXPECT_THAT(message_of_setting("frames", "0-2147483647"), HasSubstr("at most 10000000"));
  EXPECT_THAT(message_of_setting("frames", "0-9999999,0"), HasSubstr("at most 10000000"));
  RenderParams params;
  param("frames").set(params, {"0-2147483647:1000"}, "test");
  EXPECT_EQ(frames_of(*params.output.frames).size(), 2147484u);
}

TEST(ParamsTable, viewing_distance_reads_auto_inf_and_millimetres) {
  RenderParams params;
  param("viewing-distance").set(params, {"inf"}, "test");
  EXPECT_EQ(params.optics.viewing_distance_mm, kInfinity);
  param("viewing-distance").set(params, {"auto"}, "test");
  EXPECT_EQ(params.optics.viewing_distance_mm, std::nullopt);
  for (const char* bad : {"0", "-5", "nan", "near"})
    EXPECT_THAT(message_of_setting("viewing-distance", bad), HasSubstr("above 0, inf, or auto"));
}

TEST(ParamsTable, unknown_choice_lists_the_known_ones) {
  EXPECT_THAT(message_of_setting("optics", "lenticuler"), HasSubstr("lenticular, microlens, multiview, single"));
  EXPECT_THAT(message_of_setting("order", "spiral"), HasSubstr("rows, columns, view-tiles"));
}

TEST(ParamsTable, aov_keeps_each_layer_once) {
  RenderParams params;
  param("aov").set(params, {"depth,normal", "depth"}, "test");
  EXPECT_EQ(params.sampling.aov, (std::vector<Aov>{Aov::kDepth, Aov::kNormal}));
  EXPECT_THAT(message_of_setting("aov", "depth,,id"), HasSubstr("depth, normal, id, position"));
}

TEST(OutputFolder, default_is_out_slash_scene_name) {
  RenderParams params;
  params.scene.name = "some/where/BoxAnimated.glb";
  EXPECT_EQ(output_folder(params), "out/BoxAnimated");
  params.output.folder = "elsewhere";
  EXPECT_EQ(output_folder(params), "elsewhere");
}

TEST(ParamsTable, to_takes_the_formats_that_it_lists) {
  const std::string_view doc = param("to").doc;
  for (const LightFieldFormat& format : light_field_formats()) {
    const bool is_listed = (std::string(doc) + ",").find(" " + std::string(format.name) + ",") != std::string::npos;
    EXPECT_EQ(message_of_setting("to", std::string(format.name)) == "accepted", is_listed) << format.name;
  }
  EXPECT_EQ(message_of_setting("to", "hci-hdf5"),
            "--to: the format hci-hdf5 can only be read; accepted: hci, the later format of the same benchmark");
}

}  // namespace
}  // namespace lippmann
