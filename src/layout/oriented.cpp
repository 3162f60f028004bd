#include "layout/oriented.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "layout/picture_samples.hpp"

namespace lippmann {

Picture oriented(Picture picture, bool mirror, int turn_deg) {
  if (!mirror && turn_deg == 0) return picture;
  const Vec2i from = size_of(picture), to = turn_deg % 180 == 0 ? from : Vec2i(from.y, from.x);
  Picture turned = blank(picture, to);
  std::visit(
      [&](const auto& source) {
        auto out = samples_of(std::get<std::remove_cvref_t<decltype(source)>>(turned)).begin();
        for (int y = 0; y < to.y; ++y)
          for (int x = 0; x < to.x; ++x, out += 3) {
            const std::array<Vec2i, 4> places{
                {{x, y}, {y, from.y - 1 - x}, {from.x - 1 - x, from.y - 1 - y}, {from.x - 1 - y, x}}};
            Vec2i at = places[static_cast<std::size_t>(turn_deg / 90)];
            if (mirror) at.x = from.x - 1 - at.x;
            std::copy_n(samples_of(source).begin() + 3 * (static_cast<std::ptrdiff_t>(at.y) * from.x + at.x), 3, out);
          }
      },
      picture);
  return turned;
}

}  // namespace lippmann
