// The cameras of the views that plenoptic_views() extracts from a rendered raw picture.
//
// Let f be the focal length of the main lens, t its distance from the microlenses, b the gap between the microlenses and the
// sensor, and m the pixel pitch (optics/plenoptic.hpp). A view consists of the pixels that have the same offset o (in pixels)
// from the centres of their microlens images. The rays of these pixels meet at the point A = o m t/b of the main lens, the eye
// of the view. The ray through a microlens at the position l has the slope l/t - A (1/f - 1/t), so the view is a pinhole camera
// with the focal length t. Its principal point lies at l = A (t/f - 1).
#pragma once

#include <optional>
#include <vector>

#include "lippmann/layout/posed_camera.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/optics/view_cameras.hpp"

namespace lippmann {

/// The microlenses that the pixels of a view sample, in pixels of the raw picture.
struct SampledLenses {
  Vec2d first_px{0.0};  ///< centre of the image of the lens at the first pixel of the view
  Vec2d step_px{1.0};   ///< distance to the lens at the next pixel, across and down
};

/// Returns one camera per view, in the display frame. optics.model must be a PlenopticCamera. `offsets_px`: for each view, the
/// offset of its pixels from the centres of the microlens images, right and down.
std::vector<PosedCamera> plenoptic_cameras(const Optics& optics, const SampledLenses& lenses, Vec2i view_size,
                                           const std::vector<Vec2d>& offsets_px);

/// Like plenoptic_cameras(), for elemental_images(). The rays of a view meet at its eye, at the viewing distance. Views of
/// lenses that are viewed from infinity are parallel projections, so the function returns none.
std::optional<ViewCameras> microlens_cameras(const Optics& optics, const SampledLenses& lenses,
                                             const std::vector<Vec2d>& offsets_px);

}  // namespace lippmann
