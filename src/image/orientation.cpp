// Based on: "TIFF Revision 6.0", 1992, section 8, field Orientation. The field states on which sides of the image the first row
// and the first column of samples lie. For values 5 to 8, the columns of the image are stored as rows.
#include "image/orientation.hpp"

#include <algorithm>
#include <utility>

namespace lippmann {
namespace {

bool are_rows_columns(Orientation orientation) { return orientation >= Orientation::kTransposed; }

/// Returns where a pixel of the upright image is stored.
std::pair<int, int> stored_place(Orientation orientation, int x, int y, int width, int height) {
  const int last_x = width - 1, last_y = height - 1;
  switch (orientation) {
    case Orientation::kUpright:
      return {x, y};
    case Orientation::kMirrored:
      return {last_x - x, y};
    case Orientation::kUpsideDown:
      return {last_x - x, last_y - y};
    case Orientation::kFlipped:
      return {x, last_y - y};
    case Orientation::kTransposed:
      return {y, x};
    case Orientation::kRightSide:  // the first row is the right side of the image
      return {y, last_y - x};
    case Orientation::kTransversed:
      return {last_x - y, last_y - x};
    case Orientation::kLeftSide:
      return {last_x - y, x};
  }
  return {x, y};
}

template <class Sample>
std::vector<Sample> upright_samples(const std::vector<Sample>& samples, const PictureHeader& stored,
                                    const PictureHeader& header) {
  const std::size_t channels = stored.channels.size();
  std::vector<Sample> result(samples.size());
  auto to = result.begin();
  for (int y = 0; y < header.height; ++y)
    for (int x = 0; x < header.width; ++x, to += static_cast<std::ptrdiff_t>(channels)) {
      const auto [column, row] = stored_place(stored.orientation, x, y, stored.width, stored.height);
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(stored.width) + static_cast<std::size_t>(column);
      std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>(pixel * channels), channels, to);
    }
  return result;
}

}  // namespace

Orientation orientation_of(unsigned number) {
  return number >= 1 && number <= 8 ? static_cast<Orientation>(number) : Orientation::kUpright;
}

PictureHeader upright(PictureHeader header) {
  if (are_rows_columns(header.orientation)) std::swap(header.width, header.height);
  header.orientation = Orientation::kUpright;
  return header;
}

DecodedPicture upright(DecodedPicture picture) {
  if (picture.header.orientation == Orientation::kUpright) return picture;
  PictureHeader header = upright(picture.header);
  Samples samples =
      std::visit([&](const auto& stored) { return Samples(upright_samples(stored, picture.header, header)); }, picture.samples);
  return {std::move(header), std::move(samples)};
}

}  // namespace lippmann
