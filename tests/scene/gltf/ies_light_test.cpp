#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using testing::HasSubstr;

/// An IES file with 80 candela at the vertical angles from 0 (down) to 90 degrees, and no light upwards.
constexpr const char* kDownlight =
    "data:application/x-ies-lm-63;base64,SUVTOkxNLTYzLTIwMTkKVElMVD1OT05FCjEgMTAwMCAxID"
    "IgMSAxIDIgMCAwIDAgMSAxIDUwCjAgOTAKMAo4MCA4MAo=";

GltfBuilder lit_by(const Json& profile, const std::vector<Json>& lamps) {
  GltfBuilder b;
  b.root["extensions"]["EXT_lights_ies"]["lights"] = Json::array({profile});
  Json children = Json::array();
  for (std::size_t i = 0; i < lamps.size(); ++i) children.push_back(i + 1);
  b.add_node({{"children", children}});
  for (const Json& lamp : lamps) b.add_node({{"extensions", {{"EXT_lights_ies", lamp}}}});
  return b;
}

TEST(GltfIesLight, lamps_share_a_web) {
  const Scene scene = parse(lit_by({{"uri", kDownlight}, {"name", "downlight"}},
                                   {{{"light", 0}}, {{"light", 0}, {"multiplier", 2}, {"color", {1, 0.5, 0}}}}));
  validate(scene, "a.glb");
  ASSERT_EQ(scene.webs.size(), 1u);
  EXPECT_EQ(scene.webs[0].name, "downlight");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].color, Vec3f(40.0f)) << "the mean over the whole sphere";
  EXPECT_EQ(scene.lights[1].color, Vec3f(80.0f, 40.0f, 0.0f));
  for (int l : {0, 1}) {
    const Light& light = scene.lights[static_cast<std::size_t>(l)];
    EXPECT_EQ(light.web, 0);
    EXPECT_EQ(light.node, l + 1);
    EXPECT_EQ(light.kind, LightKind::kPoint);
    EXPECT_TRUE(light.inverse_square);
  }
}

TEST(GltfIesLight, missing_profile_drops_its_lamps) {
  const Scene scene = parse(lit_by({{"uri", "missing.ies"}}, {{{"light", 0}}}));
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_TRUE(scene.webs.empty());
}

TEST(GltfIesLight, damaged_profiles_and_indices_are_errors) {
  EXPECT_THAT(error_message([] {
                parse(lit_by({{"uri", "data:;base64,VElMVA=="}}, {{{"light", 0}}}));
              }),
              HasSubstr("EXT_lights_ies.lights[0]"));
  EXPECT_THAT(error_message([] {
                parse(lit_by(Json::object(), {{{"light", 0}}}));
              }),
              HasSubstr("has neither a uri nor a buffer view"));
  EXPECT_THAT(error_message([] { parse(lit_by({{"uri", kDownlight}}, {{{"light", 1}}})); }), HasSubstr("light"));
  EXPECT_THAT(error_message([] {
                parse(lit_by({{"uri", kDownlight}}, {{{"light", 0}, {"multiplier", -1}}}));
              }),
              HasSubstr("multiplier"));
}

}  // namespace
}  // namespace lippmann
