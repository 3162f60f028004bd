#include "optics/optics_kind.hpp"

#include <gtest/gtest.h>

#include "lippmann/optics/optics_of_kind.hpp"

namespace lippmann {
namespace {

TEST(OpticsKind, help_names_all_kinds) {
  EXPECT_EQ(optics_kinds_help(),
            "lenticular, microlens, multiview (a quilt of views), single (one pinhole view) or plenoptic (a camera with a main "
            "lens and microlenses before its sensor)");
}

TEST(OpticsKind, constants_are_the_kinds_of_the_list) {
  ASSERT_EQ(optics_kinds().size(), 5u);
  EXPECT_EQ(optics_kinds()[0], OpticsKind::kLenticular);
  EXPECT_EQ(optics_kinds()[3], OpticsKind::kSingle);
}

TEST(OpticsKind, names_and_values_make_optics) {
  const Optics optics = optics_of_kind("single", {40, 30, 0.5f}, R"({"distance_mm": 300})");
  EXPECT_EQ(kind_name(optics), "single");
  EXPECT_EQ(std::get<SingleView>(optics.model).distance_mm, 300.0f);
  EXPECT_EQ(optics.panel.width, 40);
}

}  // namespace
}  // namespace lippmann
