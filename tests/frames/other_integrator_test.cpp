// Renderers must work with an integrator that only this test defines.
#include <gmock/gmock.h>

#include "lippmann/core/error.hpp"
#include "lippmann/frames/renderer.hpp"
#include "lippmann/scene/builtin.hpp"
#include "lippmann/scene/load.hpp"
#include "support/error_message.hpp"
#include "trace/integrator_model.hpp"
#include "trace/trace_frame.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

constexpr float kLight = 0.25f, kNoise = 0.125f;

/// Gives all covered pixels the light kLight + kNoise in even samples and kLight - kNoise in odd ones.
class Silhouette final : public FrameIntegrator {
 public:
  Silhouette(const Integration& from) : film_(from.film), weight_(1.0f / static_cast<float>(from.params.spp)) {}

  void begin(int sample) override { light_ = kLight + (sample % 2 == 0 ? kNoise : -kNoise); }
  void primary(const CameraPacket& packet) override {
    for (int i = 0; i < kLanes; ++i) {
      if (packet.active.lane[i] == 0) continue;
      ++counts_.primary;
      if (packet.rays.hit.geomID[i] == kNoId) continue;
      for (int c = 0; c < 3; ++c) film_.all[3 * packet.target[i] + static_cast<std::size_t>(c)] += weight_ * light_;
    }
  }
  void finish() override {}
  const RayCounts& counts() const override { return counts_; }

 private:
  PathFilm film_;
  float weight_, light_ = kLight;
  RayCounts counts_;
};

std::unique_ptr<FrameIntegrator> make_silhouette(const Integration& from) { return std::make_unique<Silhouette>(from); }

constexpr IntegratorModel kQuiet{{.name = "silhouette", .default_samples = 3}, make_silhouette};
constexpr IntegratorModel kNoisy{{.name = "noisy silhouette", .default_samples = 4, .is_stochastic = true}, make_silhouette};

Renderer renderer_of(const IntegratorModel& model, const Context& context, const Reuse& reuse = {}, Sampling sampling = {}) {
  const Scene scene = load_scene("primitives", {}, context);
  sampling.integrator = Integrator(model);
  Optics optics;
  optics.panel = {64, 64, 1.0f};
  optics.model = SingleView{200.0f, {}};
  const Placement placement = place(scene, optics);
  return Renderer(scene, placement, {sampling, reuse}, context);
}

TEST(OtherIntegrator, renders_frames_with_its_own_number_of_samples) {
  const Context context;
  const auto frame = renderer_of(kQuiet, context).frame(0);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->report.rays.primary, 3u * 64u * 64u);
  EXPECT_FALSE(frame->report.estimated_psnr_db) << "it has no noise";
  // Samples 0 and 2 have the light 0.25 + 0.125, sample 1 has 0.25 - 0.125. Their mean is 0.25 + 0.125 / 3.
  EXPECT_NEAR(*std::max_element(frame->pictures.film.data.begin(), frame->pictures.film.data.end()), 0.2916667f, 1e-6f);
}

TEST(OtherIntegrator, is_audited_if_stochastic) {
  const Context context;
  const auto noisy = renderer_of(kNoisy, context).frame(0), quiet = renderer_of(kQuiet, context).frame(0);
  ASSERT_TRUE(noisy && quiet);
  EXPECT_GT(noisy->report.rays.primary, 4u * 64u * 64u) << "held-out pixels are traced again";
  EXPECT_EQ(quiet->report.rays.primary, 3u * 64u * 64u);
}

TEST(OtherIntegrator, supports_only_its_stated_features) {
  const Context context;
  const auto refusal = [&](const Reuse& reuse, const Sampling& sampling = {}) {
    return error_message([&] { renderer_of(kQuiet, context, reuse, sampling); });
  };
  EXPECT_THAT(refusal(CopySettled{}), HasSubstr("copy needs"));
  EXPECT_THAT(refusal(Interpolate{}), HasSubstr("interpolate needs"));
  EXPECT_THAT(refusal({}, {.aov = {Aov::kIndirect}}), HasSubstr("direct and indirect"));
}

}  // namespace
}  // namespace lippmann
