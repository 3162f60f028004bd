#include "trace/trace_batch.hpp"

#include <gtest/gtest.h>

#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

struct CountingIntegrator {
  std::vector<int> rays, hits;
  std::vector<char> calls;  ///< 'b': begin, 'p': primary, 'f': finish

  explicit CountingIntegrator(std::size_t pixels) : rays(pixels), hits(pixels) {}

  void begin(int) { calls.push_back('b'); }
  void primary(const CameraPacket& packet) {
    calls.push_back('p');
    for (int i = 0; i < kLanes; ++i) {
      if (!packet.active.lane[i]) continue;
      ++rays[packet.target[i]];
      hits[packet.target[i]] += packet.rays.hit.geomID[i] != kNoId;
    }
  }
  void finish() { calls.push_back('f'); }
};

class TraceBatch : public ::testing::Test {
 protected:
  /// The square fills the left half of 20 x 20 pixels. 20 is not a multiple of a packet's 16 lanes.
  TraceBatch() {
    s_.add(square(0.5f, 0.0f), s_.material(matte(Vec3f(0.5f))), s_.node({Mat3f(1.0f), {-0.5f, 0.0f, 0.0f}}));
    device_.emplace(s_.scene, pool_);
    device_->update(evaluate(s_.scene, 0.0), pool_);
  }

  SmallScene s_;
  const ThreadPool pool_{1};
  const Optics optics_ = single_view(20);
  std::optional<DeviceScene> device_;
  CountingIntegrator integrator_{400};
};

TEST_F(TraceBatch, every_pixel_has_one_central_ray) {
  trace_centres({*device_, optics_, {}}, RayOrder::kRows, pool_, integrator_);
  int seen = 0;
  for (std::size_t p = 0; p < 400; ++p) {
    EXPECT_EQ(integrator_.rays[p], 1) << p;
    EXPECT_LE(integrator_.hits[p], p % 20 < 10 ? 1 : 0) << p;
    seen += integrator_.hits[p];
  }
  EXPECT_GT(seen, 0);
}

TEST_F(TraceBatch, batches_are_shaded_before_they_finish) {
  const PacketSource source(optics_, {}, RayOrder::kRows, SubPixel{});
  const int packets[] = {0, 3};
  trace_batch(device_->shaded(), StripPackets{source, 0}, {packets, 1, 3}, integrator_);
  EXPECT_EQ(std::string(integrator_.calls.begin(), integrator_.calls.end()), "bppfbppf");
}

TEST_F(TraceBatch, only_traced_pixels_are_cleared) {
  const PacketSource source(optics_, {}, RayOrder::kRows, SubPixel{});
  Image film(20, 20, 3);
  std::fill(film.data.begin(), film.data.end(), 7.0f);
  const int packets[] = {2};
  trace_batch(device_->shaded(), StripPackets{source, 0}, {packets}, integrator_, {&film});
  for (std::size_t p = 0; p < 400; ++p) EXPECT_EQ(film.data[3 * p], integrator_.rays[p] ? 0.0f : 7.0f) << p;
}

TEST(FrameWork, wanted_packets_form_batches) {
  std::vector<std::uint8_t> wanted(2 * 40, 0);
  for (const int p : {1, 5, 39}) wanted[40 + static_cast<std::size_t>(p)] = 1;
  std::vector<std::vector<int>> batches;
  const auto keep = [&](std::span<const int> batch, std::size_t) { batches.emplace_back(batch.begin(), batch.end()); };
  for_each_batch({FrameWork::Unit::kPackets, wanted}, 0, 40, keep);
  EXPECT_TRUE(batches.empty());
  for_each_batch({FrameWork::Unit::kPackets, wanted}, 1, 40, keep);
  EXPECT_EQ(batches, (std::vector<std::vector<int>>{{1, 5, 39}}));

  std::vector<std::uint8_t> blocks(2 * 3, 0);  // a strip of 40 packets has blocks of 16, 16 and 8 packets
  blocks[5] = 1;
  batches.clear();
  std::size_t block = 0;
  for_each_batch({FrameWork::Unit::kBlocks, blocks}, 1, 40, [&](std::span<const int> batch, std::size_t b) {
    keep(batch, b);
    block = b;
  });
  ASSERT_EQ(batches.size(), 1u);
  EXPECT_EQ(batches[0].size(), 8u);
  EXPECT_EQ(batches[0].front(), 32);
  EXPECT_EQ(block, 5u);
}

}  // namespace
}  // namespace lippmann
