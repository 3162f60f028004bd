#include "scene/tachyon/landscape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace lippmann::tachyon {
namespace {

class Terrain {
 public:
  explicit Terrain(const LandscapeSize& size)
      : size_(size),
        heights_(static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows), 0.0),
        random_state_(static_cast<std::uint32_t>(size.columns) * static_cast<std::uint32_t>(size.rows)),
        roughness_(std::hypot(size.width, size.depth) / 64.0) {}

  std::vector<double> heights() {
    const int right = size_.columns - 1, far = size_.rows - 1;
    for (const auto [x, y] : {Point{0, 0}, Point{right, 0}, Point{0, far}, Point{right, far}}) at(x, y) = random();
    subdivide({0, 0}, {right, far});
    return std::move(heights_);
  }

 private:
  struct Point {
    int x, y;
  };

  double& at(int x, int y) {
    return heights_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.columns) + static_cast<std::size_t>(x)];
  }

  double random() {
    random_state_ *= 1099087573u;
    return random_state_ / 4294967296.0;
  }

  /// Sets the height of m, the midpoint of the edge from a to b, to the mean of both ends plus a random displacement. Does
  /// nothing if m already has a height.
  void displace(Point m, Point a, Point b) {
    if (at(m.x, m.y) != 0.0) return;
    const double length =
        std::abs(a.x - b.x) / double(size_.columns) * size_.width + std::abs(a.y - b.y) / double(size_.rows) * size_.depth;
    const double height = (at(a.x, a.y) + at(b.x, b.y)) / 2.0 + (random() - 0.5) * length * roughness_;
    at(m.x, m.y) = std::clamp(height, 0.0, double(size_.columns) + size_.rows);
  }

  void subdivide(Point low, Point high) {
    if (high.x - low.x < 2 && high.y - low.y < 2) return;
    const Point m{(low.x + high.x) / 2, (low.y + high.y) / 2};
    displace({m.x, low.y}, low, {high.x, low.y});
    displace({high.x, m.y}, {high.x, low.y}, high);
    displace({m.x, high.y}, {low.x, high.y}, high);
    displace({low.x, m.y}, low, {low.x, high.y});
    if (double& middle = at(m.x, m.y); middle == 0.0)
      middle = (at(low.x, low.y) + at(high.x, low.y) + at(high.x, high.y) + at(low.x, high.y)) / 4.0;
    subdivide(low, m);
    subdivide({m.x, low.y}, {high.x, m.y});
    subdivide(m, high);
    subdivide({low.x, m.y}, {m.x, high.y});
  }

  LandscapeSize size_;
  std::vector<double> heights_;
  std::uint32_t random_state_;
  double roughness_;
};

}  // namespace

std::vector<double> landscape_heights(const LandscapeSize& size) { return Terrain(size).heights(); }

}  // namespace lippmann::tachyon
