#include "job/settings_command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "job/settings_json.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;

TEST(SettingsCommand, defaults_are_omitted) {
  EXPECT_EQ(command_of_settings("room", settings_json(RenderParams{})), "lippmann render room");
}

TEST(SettingsCommand, settings_become_flags_in_their_order) {
  RenderParams params;
  params.sampling.spp = 4;
  params.optics.lenses = {32, 0};
  params.output.video = {"a.mp4", "b b.mkv"};
  params.output.folder = "out/x";
  params.resume = true;
  EXPECT_EQ(command_of_settings("my room.glb", settings_json(params)),
            "lippmann render 'my room.glb' --lenses 32 --spp 4 --output out/x --video a.mp4 --video 'b b.mkv'");
}

TEST(SettingsCommand, switches_have_their_own_flags) {
  EXPECT_EQ(flags_of_setting("transparent", true), "--transparent");
  EXPECT_EQ(flags_of_setting("transparent", false), "");
}

TEST(SettingsCommand, untrusted_values_are_quoted) {
  EXPECT_EQ(flags_of_setting("newer-flag", "a; rm b"), "--newer-flag 'a; rm b'");
  EXPECT_EQ(flags_of_setting("x; rm b", 1), "'--x; rm b' 1");
  EXPECT_EQ(flags_of_setting("newer-flag", Json{{"x", 1}}), R"(--newer-flag '{"x":1}')");
}

}  // namespace
}  // namespace lippmann
