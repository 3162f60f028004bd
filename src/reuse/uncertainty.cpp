#include "reuse/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/multiversion.hpp"
#include "optics/view_steps.hpp"

namespace lippmann {
namespace {

constexpr int kRowsPerPiece = 16;

using Byte = std::uint8_t;

LIPPMANN_INLINE Byte larger(Byte a, Byte b) { return a > b ? a : b; }
LIPPMANN_INLINE Byte difference(Byte a, Byte b) { return static_cast<Byte>(a > b ? a - b : b - a); }

LIPPMANN_MULTIVERSION void code_row(const float* film, int count, bool linear, Byte* codes) {
  for (int x = 0; x < count; ++x) {
    const float positive = film[x] > 0.0f ? film[x] : 0.0f, value = positive < 1.0f ? positive : 1.0f;
    const float root = std::sqrt(value), shown = linear ? root : value;
    codes[x] = static_cast<Byte>(static_cast<int>(255.0f * shown + 0.5f));
  }
}

LIPPMANN_MULTIVERSION void take_channels(const Byte* rgb, int width, Byte* r, Byte* g, Byte* b) {
  for (int x = 0; x < width; ++x) r[x] = rgb[3 * x], g[x] = rgb[3 * x + 1], b[x] = rgb[3 * x + 2];
}

LIPPMANN_MULTIVERSION void compare_rows(const Byte* rgb_a, const Byte* rgb_b, int width, Byte* largest) {
  for (int x = 0; x < width; ++x) {
    const Byte r = difference(rgb_a[3 * x], rgb_b[3 * x]), g = difference(rgb_a[3 * x + 1], rgb_b[3 * x + 1]);
    largest[x] = larger(larger(r, g), difference(rgb_a[3 * x + 2], rgb_b[3 * x + 2]));
  }
}

/// Extends a row at both ends, so that a pixel without a neighbour is compared with itself.
void fill_margins(Byte* row, int width, int across) {
  std::memcpy(row - across, row, static_cast<std::size_t>(across));
  std::memcpy(row + width, row + width - across, static_cast<std::size_t>(across));
}

LIPPMANN_MULTIVERSION void take_larger(const Byte* values, int width, Byte* largest) {
  for (int x = 0; x < width; ++x) largest[x] = larger(largest[x], values[x]);
}

LIPPMANN_MULTIVERSION void take_contrast(const Byte* here, const Byte* there, int width, Byte* largest) {
  for (int x = 0; x < width; ++x) largest[x] = larger(largest[x], difference(here[x], there[x]));
}

/// For each pixel of a row: the terms A, a', g and g' of the formula in uncertainty.hpp.
struct Signals {
  std::vector<Byte> around, beside, contrast, contrast_beside;

  explicit Signals(std::size_t width) : around(width), beside(width), contrast(width), contrast_beside(width) {}
  void clear() {
    for (std::vector<Byte>* row : {&around, &beside, &contrast, &contrast_beside}) std::fill(row->begin(), row->end(), Byte{0});
  }
};

LIPPMANN_MULTIVERSION void add_up(const Byte* own, const Signals& signals, const std::uint64_t* keys_a,
                                  const std::uint64_t* keys_b, int width, Byte* uncertainty) {
  const Byte *around = signals.around.data(), *beside = signals.beside.data(), *contrast = signals.contrast.data(),
             *contrast_beside = signals.contrast_beside.data();
  for (int x = 0; x < width; ++x) {
    const int sum = own[x] + around[x] / 2 + beside[x] / 2 + contrast[x] / 8 + contrast_beside[x] / 8;
    const int missing = (keys_a[x] == 0 ? 1 : 0) + (keys_b[x] == 0 ? 1 : 0);
    const int some = missing > 0 ? kOneKeyUncertainty : 0, least = missing > 1 ? kMissedUncertainty : some;
    const int limited = sum < 255 ? sum : 255;
    uncertainty[x] = static_cast<Byte>(limited > least ? limited : least);
  }
}

int whole_step(float length_px, int size) { return std::clamp(static_cast<int>(std::lround(length_px)), 1, size); }

}  // namespace

UncertaintyEstimator::UncertaintyEstimator(const Optics& optics, Encoding encoding)
    : width_(film_size(optics).x), height_(film_size(optics).y), linear_film_(encoding == Encoding::kSrgb) {
  const ViewSteps steps(optics, StepsWithin::kView);
  across_ = whole_step(steps.length_px(StepDirection::kRight), width_);
  down_ = whole_step(steps.length_px(StepDirection::kDown), height_);
  stride_ = static_cast<std::size_t>(width_) + 2 * static_cast<std::size_t>(across_);
  for (Plane* plane : {&disagreement_, &codes_[0], &codes_[1], &codes_[2]})
    plane->resize(stride_ * static_cast<std::size_t>(height_));
}

void UncertaintyEstimator::make_planes(const Prediction& previous, const Prediction& following, const Image& film, int row) {
  const std::size_t values = 3 * static_cast<std::size_t>(width_), from = values * static_cast<std::size_t>(row);
  const std::size_t to = stride_ * static_cast<std::size_t>(row) + static_cast<std::size_t>(across_);
  std::vector<Byte> a(values), b(values);
  code_row(previous.colors.data.data() + from, 3 * width_, linear_film_, a.data());
  code_row(following.colors.data.data() + from, 3 * width_, linear_film_, b.data());
  compare_rows(a.data(), b.data(), width_, disagreement_.data() + to);
  code_row(film.data.data() + from, 3 * width_, linear_film_, a.data());
  take_channels(a.data(), width_, codes_[0].data() + to, codes_[1].data() + to, codes_[2].data() + to);
  for (Plane* plane : {&disagreement_, &codes_[0], &codes_[1], &codes_[2]}) fill_margins(plane->data() + to, width_, across_);
}

void UncertaintyEstimator::estimate(const Prediction& previous, const Prediction& following, const Image& film,
                                    const ThreadPool& pool, std::vector<std::uint8_t>& uncertainty) {
  const auto width = static_cast<std::size_t>(width_);
  uncertainty.resize(width * static_cast<std::size_t>(height_));
  const auto for_each_row = [&](const auto& fn) {
    pool.for_each(static_cast<std::size_t>((height_ + kRowsPerPiece - 1) / kRowsPerPiece), [&](std::size_t piece) {
      const int first = static_cast<int>(piece) * kRowsPerPiece;
      fn(first, std::min(height_, first + kRowsPerPiece));
    });
  };
  for_each_row([&](int first, int end) {
    for (int row = first; row < end; ++row) make_planes(previous, following, film, row);
  });
  for_each_row([&](int first, int end) {
    Signals signals(width);
    for (int row = first; row < end; ++row) {
      signals.clear();
      const auto at = [&](int r) { return stride_ * static_cast<std::size_t>(r) + static_cast<std::size_t>(across_); };
      const std::size_t here = at(row);
      for (const int r : {row - down_, row, row + down_}) {
        if (r < 0 || r >= height_) continue;
        for (const int step : {-across_, 0, across_}) {
          const std::size_t there = at(r) + static_cast<std::size_t>(step);
          take_larger(disagreement_.data() + there, width_, signals.around.data());
          for (const Plane& codes : codes_)
            take_contrast(codes.data() + here, codes.data() + there, width_, signals.contrast.data());
        }
      }
      for (const int step : {-1, 1}) {
        const std::size_t there = here + static_cast<std::size_t>(step);
        take_larger(disagreement_.data() + there, width_, signals.beside.data());
        for (const Plane& codes : codes_)
          take_contrast(codes.data() + here, codes.data() + there, width_, signals.contrast_beside.data());
      }
      const std::size_t pixel = width * static_cast<std::size_t>(row);
      add_up(disagreement_.data() + here, signals, previous.landed.keys.data() + pixel, following.landed.keys.data() + pixel,
             width_, uncertainty.data() + pixel);
    }
  });
}

}  // namespace lippmann
