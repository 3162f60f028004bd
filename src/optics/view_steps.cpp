#include "optics/view_steps.hpp"

#include <cmath>

#include "optics/slanted_panel.hpp"

namespace lippmann {

ViewSteps::ViewSteps(const Optics& optics, StepsWithin within) : width_(optics.panel.width), height_(optics.panel.height) {
  const bool below_lens = within == StepsWithin::kLens;
  if (const auto* sheet = std::get_if<LenticularSheet>(&optics.model)) {
    sheet_ = make_lenticular(optics.panel, *sheet, 0.0).as<float>();
    if (below_lens)
      bounds_ = Bounds::kSheetLens;
    else
      across_.x = sheet_.axis.cell_px * sheet_.inverse_cosine;
    down_.x = sheet_.sine * sheet_.inverse_cosine;  // along the lens
  } else if (const auto* array = std::get_if<MicrolensArray>(&optics.model)) {
    lenses_ = make_microlens(optics.panel, *array, 0.0).as<float>();
    const bool hexagonal = array->packing == LensPacking::kHexagonal;
    if (below_lens) {
      bounds_ = hexagonal ? Bounds::kHexagon : Bounds::kSquareLens;
    } else {
      across_.x = lenses_.columns.cell_px;
      // Every second row of a hexagonal array has its lenses in the same columns.
      down_.y = lenses_.rows.cell_px * (hexagonal ? 2.0f : 1.0f);
    }
  } else if (const auto* views = std::get_if<MultiView>(&optics.model)) {
    bounds_ = Bounds::kTile;
    tile_ = {width_ / views->columns, height_ / views->rows};
    last_tile_ = {views->columns - 1, views->rows - 1};
    padding_top_ = height_ - views->rows * tile_.y;
  } else if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) {
    const SlantedPanelRays c = make_slanted_panel(optics.panel, *slanted, 0.0f);
    across_.x = static_cast<float>(3.0 / std::abs(c.lenses_per_px));
    down_.x = static_cast<float>(3.0 * c.lenses_per_row / c.lenses_per_px);  // along the lens: a row down is a row less
  }
}

Vec2f ViewSteps::step_of(StepDirection direction) const {
  switch (direction) {
    case StepDirection::kLeft:
      return -across_;
    case StepDirection::kRight:
      return across_;
    case StepDirection::kUp:
      return -down_;
    case StepDirection::kDown:
      break;
  }
  return down_;
}

void ViewSteps::limit_to_tile(Vec2f place, ViewWalk& walk) const {
  const Vec2i at(place.x, std::max(0.0f, place.y - static_cast<float>(padding_top_)));
  const Vec2i tile = glm::min(at / tile_, last_tile_), first(tile.x * tile_.x, padding_top_ + tile.y * tile_.y);
  // Padding belongs to the tile next to it.
  walk.low_ = {first.x, tile.y == 0 ? 0 : first.y};
  walk.high_ = {tile.x == last_tile_.x ? width_ : first.x + tile_.x, first.y + tile_.y};
}

/// From one pixel's edge to another: a pixel belongs to the lens above its centre.
void ViewSteps::limit_to_lens(Vec2f place, ViewWalk& walk) const {
  const auto limit = [](const LensAxis<float>& axis, float s, float shift, float scale, float& low, float& high) {
    const float begin = axis.start_px + std::floor((s - axis.start_px) * axis.cells_per_px) * axis.cell_px;
    low = std::max(low, std::ceil((begin + shift) * scale - 0.5f));
    high = std::min(high, std::ceil((begin + axis.cell_px + shift) * scale - 0.5f));
  };
  if (bounds_ == Bounds::kSheetLens) {
    const float shift = place.y * sheet_.sine;
    limit(sheet_.axis, place.x * sheet_.cosine - shift, shift, sheet_.inverse_cosine, walk.low_.x, walk.high_.x);
  } else if (bounds_ == Bounds::kSquareLens) {
    limit(lenses_.columns, place.x, 0.0f, 1.0f, walk.low_.x, walk.high_.x);
    limit(lenses_.rows, place.y, 0.0f, 1.0f, walk.low_.y, walk.high_.y);
  } else {
    const HexagonalCell<float> cell = hexagon_at(lenses_, place.x, place.y);
    const Vec2f size(lenses_.columns.cell_px, lenses_.rows.cell_px);
    const Vec2f centre = place - Vec2f(cell.from_column, cell.from_row) * size;
    walk.low_ = glm::max(walk.low_, glm::ceil(centre - 0.5f * size - 0.5f));
    walk.high_ = glm::min(walk.high_, glm::ceil(centre + 0.5f * size - 0.5f));
  }
}

ViewWalk ViewSteps::walk(std::uint32_t pixel, StepDirection direction) const {
  ViewWalk walk;
  walk.width_ = static_cast<std::uint32_t>(width_);
  walk.place_ = {static_cast<float>(pixel % walk.width_) + 0.5f, static_cast<float>(pixel / walk.width_) + 0.5f};
  walk.step_ = step_of(direction);
  walk.low_ = Vec2f(0.0f), walk.high_ = {width_, height_};
  const bool along_slanted = walk.step_.x != 0.0f && walk.step_.y != 0.0f;
  if (bounds_ == Bounds::kTile)
    limit_to_tile(walk.place_, walk);
  else if (bounds_ != Bounds::kPanel && !along_slanted)
    limit_to_lens(walk.place_, walk);
  return walk;
}

}  // namespace lippmann
