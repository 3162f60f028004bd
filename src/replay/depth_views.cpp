#include "replay/depth_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "formats/rgbd_side_file.hpp"
#include "image/resample.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr float kNoPoint = -std::numeric_limits<float>::infinity();
constexpr double kSameSurfacePx = 1.5;  ///< largest distance of neighbouring points of a surface, in pixels of the view

/// The source image, scaled to the screen of the views.
struct DepthPicture {
  Image colours;
  Image disparity;   ///< disparity q (depth_views.hpp), in mm on the screen
  Vec2d slope{0.0};  ///< position of the source's eye relative to the axis, per mm of distance
  Vec2d size_mm{0.0};

  Vec2d place_mm(Vec2d pixel) const {
    return (pixel / Vec2d(colours.width, colours.height) - 0.5) * Vec2d(1.0, -1.0) * size_mm;
  }
  Vec2d pixel_at(Vec2d place_mm) const {
    return (place_mm / size_mm * Vec2d(1.0, -1.0) + 0.5) * Vec2d(colours.width, colours.height);
  }
};

/// Resizes an image of depths. Takes the nearest pixel, because a mean depth of two surfaces would lie on neither of them.
Image nearest_samples(const Image& picture, Vec2i size) {
  Image result(size.x, size.y, 1);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const int u = static_cast<int>((x + 0.5) * picture.width / size.x),
                v = static_cast<int>((y + 0.5) * picture.height / size.y);
      result.pixel(x, y)[0] = picture.pixel(u, v)[0];
    }
  return result;
}

DepthPicture depth_picture(const LightField& source, Vec2d window_mm, Vec2i view, double depth_scale) {
  const ViewCameras& camera = *source.cameras;
  const Vec2d own_mm = camera.pixel_mm * Vec2d(source.view_size);
  const double k = std::max(window_mm.x / own_mm.x, window_mm.y / own_mm.y);
  const Vec2i wanted(glm::ceil(Vec2d(view) * own_mm * k / window_mm - 1e-9));
  const Vec2i size = glm::min(source.view_size, wanted);
  DepthPicture picture;
  picture.size_mm = own_mm * k;
  picture.slope = camera.eyes_mm.front() / camera.distance_mm;
  picture.colours = resampled(to_linear(source.stack), size);
  picture.disparity = nearest_samples(*source.depth, size);
  for (float& z : picture.disparity.data) z = static_cast<float>(depth_scale * k * disparity_of_depth(z, camera.distance_mm));
  return picture;
}

class ViewMaker {
 public:
  /// slope: offset of the view's eye from the source's eye, per mm of distance
  ViewMaker(const DepthPicture& source, Vec2d slope, Vec2d window_mm, Vec2i size)
      : source_(source), slope_(slope), window_mm_(window_mm), colours_(size.x, size.y, 3), disparity_(size.x, size.y, 1) {
    std::fill(disparity_.data.begin(), disparity_.data.end(), kNoPoint);
  }

  void show() {
    splat();
    for (int y = 0; y < disparity_.height; ++y)
      for (int x = 0; x < disparity_.width; ++x)
        if (has_point(x, y)) take_colour(x, y);
  }

  /// Fills empty pixels from `other`, a view from the same eye that was made from another source.
  void complete_from(const ViewMaker& other) {
    for (int y = 0; y < disparity_.height; ++y)
      for (int x = 0; x < disparity_.width; ++x) {
        if (has_point(x, y) || !other.has_point(x, y)) continue;
        disparity_.pixel(x, y)[0] = other.disparity_.pixel(x, y)[0];
        std::copy_n(other.colours_.pixel(x, y), 3, colours_.pixel(x, y));
      }
  }

  void fill() {
    std::vector<Vec2i> holes;
    for (int y = 0; y < disparity_.height; ++y)
      for (int x = 0; x < disparity_.width; ++x)
        if (!has_point(x, y)) holes.push_back({x, y});
    missed_ = static_cast<std::int64_t>(holes.size());
    std::vector<float> depths;
    for (const Vec2i hole : holes) depths.push_back(fill_colour(hole));
    for (std::size_t i = 0; i < holes.size(); ++i) disparity_.pixel(holes[i].x, holes[i].y)[0] = depths[i];
  }

  const Image& colours() const { return colours_; }
  const Image& disparity() const { return disparity_; }
  std::int64_t missed() const { return missed_; }

 private:
  double pixel_mm() const { return window_mm_.x / colours_.width; }
  bool has_point(int x, int y) const { return disparity_.pixel(x, y)[0] != kNoPoint; }

  bool same_surface(double a, double b) const { return std::abs(a - b) * glm::length(slope_) <= kSameSurfacePx * pixel_mm(); }

  Vec2d landing(Vec2d source_pixel, double q) const {
    const Vec2d t = source_.place_mm(source_pixel) - slope_ * q;
    return (t / window_mm_ * Vec2d(1.0, -1.0) + 0.5) * Vec2d(colours_.width, colours_.height);
  }

  float source_disparity(int x, int y) const {
    return source_.disparity.pixel(std::clamp(x, 0, source_.disparity.width - 1),
                                   std::clamp(y, 0, source_.disparity.height - 1))[0];
  }

  /// Interpolates the disparity at `at` from the four nearest pixel centres if they belong to one surface. Otherwise returns
  /// the disparity of pixel (i, j).
  double disparity_at(int i, int j, Vec2d at) const {
    const double own = source_disparity(i, j);
    const Vec2d from = at - 0.5;
    const Vec2i corner(glm::floor(from));
    const Vec2d share = from - Vec2d(corner);
    double sum = 0.0;
    for (int v = 0; v < 2; ++v)
      for (int u = 0; u < 2; ++u) {
        const double q = source_disparity(corner.x + u, corner.y + v);
        if (!same_surface(q, own)) return own;
        sum += q * (u ? share.x : 1.0 - share.x) * (v ? share.y : 1.0 - share.y);
      }
    return sum;
  }

  void splat() {
    const Vec2i samples =
        (2 * Vec2i(colours_.width, colours_.height) + Vec2i(source_.colours.width, source_.colours.height) - 1) /
        Vec2i(source_.colours.width, source_.colours.height);
    for (int j = 0; j < source_.colours.height; ++j)
      for (int i = 0; i < source_.colours.width; ++i)
        for (int v = 0; v < samples.y; ++v)
          for (int u = 0; u < samples.x; ++u) {
            const Vec2d at(i + (u + 0.5) / samples.x, j + (v + 0.5) / samples.y);
            const double q = disparity_at(i, j, at);
            const Vec2i pixel(glm::floor(landing(at, q)));
            if (pixel.x < 0 || pixel.y < 0 || pixel.x >= colours_.width || pixel.y >= colours_.height) continue;
            float& nearest = disparity_.pixel(pixel.x, pixel.y)[0];
            nearest = std::max(nearest, static_cast<float>(q));
          }
  }

  void take_colour(int x, int y) {
    const double q = disparity_.pixel(x, y)[0];
    const Vec2d t = (Vec2d(x + 0.5, y + 0.5) / Vec2d(colours_.width, colours_.height) - 0.5) * Vec2d(1.0, -1.0) * window_mm_;
    const Vec2d from = source_.pixel_at(t + slope_ * q) - 0.5;
    const Vec2i corner(glm::floor(from));
    const Vec2d share = from - Vec2d(corner);
    Vec3d sum(0.0);
    double weights = 0.0;
    for (int v = 0; v < 2; ++v)
      for (int u = 0; u < 2; ++u) {
        const int i = std::clamp(corner.x + u, 0, source_.colours.width - 1),
                  j = std::clamp(corner.y + v, 0, source_.colours.height - 1);
        if (!same_surface(source_.disparity.pixel(i, j)[0], q)) continue;
        const double weight = 1e-6 + (u ? share.x : 1.0 - share.x) * (v ? share.y : 1.0 - share.y);
        const float* c = source_.colours.pixel(i, j);
        sum += weight * Vec3d(c[0], c[1], c[2]);
        weights += weight;
      }
    if (weights > 0.0)
      set_colour(x, y, sum / weights);
    else
      disparity_.pixel(x, y)[0] = kNoPoint;
  }

  void set_colour(int x, int y, Vec3d colour) {
    float* pixel = colours_.pixel(x, y);
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(colour[c]);
  }

  /// The nearest pixel with a point in one direction from an empty pixel.
  struct Neighbour {
    int x, y, steps;
  };

  void find_neighbour(Vec2i from, Vec2i step, std::vector<Neighbour>& found) const {
    int steps = 1;
    for (Vec2i at = from + step; at.x >= 0 && at.y >= 0 && at.x < colours_.width && at.y < colours_.height; at += step, ++steps)
      if (has_point(at.x, at.y)) return found.push_back({at.x, at.y, steps});
  }

  /// Fills an empty pixel with the mean colour of its neighbours on the farthest surface. Returns the disparity of that
  /// surface.
  float fill_colour(Vec2i hole) {
    std::vector<Neighbour> found;
    for (const int side : {-1, 1}) find_neighbour(hole, {side, 0}, found);
    if (found.empty())
      for (const int side : {-1, 1}) find_neighbour(hole, {0, side}, found);
    if (found.empty()) return kNoPoint;
    float farthest = std::numeric_limits<float>::infinity();
    for (const Neighbour& n : found) farthest = std::min(farthest, disparity_.pixel(n.x, n.y)[0]);
    Vec3d sum(0.0);
    double weights = 0.0;
    for (const Neighbour& n : found) {
      if (!same_surface(disparity_.pixel(n.x, n.y)[0], farthest)) continue;
      const float* c = colours_.pixel(n.x, n.y);
      sum += Vec3d(c[0], c[1], c[2]) / static_cast<double>(n.steps);
      weights += 1.0 / n.steps;
    }
    set_colour(hole.x, hole.y, sum / weights);
    return farthest;
  }

  const DepthPicture& source_;
  Vec2d slope_, window_mm_;
  Image colours_, disparity_;
  std::int64_t missed_ = 0;
};

ViewCameras cameras_for(const Optics& optics) {
  if (const std::optional<RenderedViews> rendered = rendered_views(optics); rendered && rendered->cameras)
    return *rendered->cameras;
  throw Error("optics", "the cameras of their views are unknown", "the optics of a quilt or of a camera grid");
}

LightField empty_views(const Optics& optics, const ViewCameras& cameras) {
  const ViewLayout film = rendered_views(optics)->film;
  LightField field;
  field.grid = film.grid, field.cameras = cameras;
  field.view_size = view_size(film, film_size(optics), "optics");
  if (film.kind == LayoutKind::kQuilt) field.tiles = film.tiles;
  const Vec2f window = window_size_mm(optics);
  field.aspect = static_cast<double>(window.x) / window.y;
  const Vec2i size = stack_size(field);
  field.stack = Image(size.x, size.y, 3), field.depth = Image(size.x, size.y, 1);
  return field;
}

std::vector<const DepthPicture*> nearest_first(const std::vector<DepthPicture>& pictures, Vec2d slope) {
  std::vector<const DepthPicture*> order;
  for (const DepthPicture& picture : pictures) order.push_back(&picture);
  std::stable_sort(order.begin(), order.end(), [&](const DepthPicture* a, const DepthPicture* b) {
    return glm::length(a->slope - slope) < glm::length(b->slope - slope);
  });
  return order;
}

Image depths_of(const Image& disparity, double distance_mm) {
  Image depth = disparity;
  for (float& z : depth.data) z = z == kNoPoint ? kNoPoint : static_cast<float>(depth_of_disparity(z, distance_mm));
  return depth;
}

}  // namespace

DepthViews views_from_depth(const LightField& source, const Optics& optics, double depth_scale, const ThreadPool& pool) {
  return views_from_depths(std::span(&source, 1), optics, depth_scale, pool);
}

DepthViews views_from_depths(std::span<const LightField> sources, const Optics& optics, double depth_scale,
                             const ThreadPool& pool) {
  const ViewCameras cameras = cameras_for(optics);
  DepthViews made{empty_views(optics, cameras)};
  const Vec2d window = window_size_mm(optics);
  const Vec2i size = made.field.view_size;
  std::vector<DepthPicture> pictures;
  for (const LightField& source : sources) pictures.push_back(depth_picture(source, window, size, depth_scale));
  std::vector<std::int64_t> missed(cameras.eyes_mm.size());
  pool.for_each(cameras.eyes_mm.size(), [&](std::size_t v) {
    const Vec2d slope = cameras.eyes_mm[v] / cameras.distance_mm;
    std::vector<ViewMaker> makers;
    makers.reserve(pictures.size());
    for (const DepthPicture* picture : nearest_first(pictures, slope))
      makers.emplace_back(*picture, slope - picture->slope, window, size).show();
    ViewMaker& view = makers.front();
    for (std::size_t i = 1; i < makers.size(); ++i) view.complete_from(makers[i]);
    view.fill();
    missed[v] = view.missed();
    set_view(made.field, static_cast<int>(v), view.colours());
    set_depth(made.field, static_cast<int>(v), depths_of(view.disparity(), cameras.distance_mm));
  });
  std::int64_t all = 0;
  for (const std::int64_t count : missed) all += count;
  made.filled_share = static_cast<double>(all) / (static_cast<double>(size.x) * size.y * static_cast<double>(missed.size()));
  return made;
}

}  // namespace lippmann
