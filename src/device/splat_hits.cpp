#include "device/splat_hits.hpp"

#include <cstddef>

namespace lippmann {
namespace {

bool is_before(const SplatHit& a, const SplatHit& b) { return a.t != b.t ? a.t < b.t : a.splat < b.splat; }

}  // namespace

float SplatHits::add(std::size_t lane, SplatHit hit, float reach) {
  std::vector<SplatHit>& hits = of_lane_[lane];
  std::size_t place = hits.size();
  while (place > 0 && is_before(hit, hits[place - 1])) --place;
  float left = place > 0 ? hits[place - 1].left : 1.0f;
  if (left < kDark) return reach;
  hits.insert(hits.begin() + static_cast<std::ptrdiff_t>(place), hit);
  for (; place < hits.size(); ++place) {
    left *= 1.0f - hits[place].alpha;
    hits[place].left = left;
    if (left < kDark) {
      hits.resize(place + 1);
      return std::min(reach, hits[place].t);
    }
  }
  return reach;
}

}  // namespace lippmann
