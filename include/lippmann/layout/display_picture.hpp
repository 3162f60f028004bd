// The pictures of a display, made of views of any size: what a sheet of lenses is laid on, a quilt, or a panel's native frame.
//
// Views are cropped or padded to the shape of the display and resampled, in linear light, to what it resolves: by area where
// they get smaller, by Lanczos (3 lobes) where they get larger. They spread evenly over the viewing zone, view 0 from the left.
// Below the lenses of a sheet they lie in the opposite order, view N - 1 at the left. All functions give the same bits for any
// number of threads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/interlace.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// How a view of another shape fills the display.
enum class AspectFit { kCrop, kPad, kStretch };

/// A flip print: frames take the place of views. Below each lens, frame 0 lies at the left.
struct FlipParams {
  std::vector<double> shares = {};  ///< of the lens, one for each frame, above 0, in any unit; empty: equal shares
  double blend = 0.0;  ///< 0: hard transitions; 1: each transition spreads over the smaller of the two shares that it joins
};

/// Bleed and marks around the print of a sheet or an array, on the paper that it is cut from.
struct PrintFinish {
  double bleed_mm = 0.0;  ///< how far the picture goes on beyond each edge at which the print is cut
  bool marks = false;     ///< a margin of 10 mm with crop marks, targets, figures, and bands to align a sheet by
  bool proof = false;     ///< the middle square inch of the print instead of all of it, pixel by pixel the same

  bool is_plain() const { return bleed_mm == 0.0 && !marks && !proof; }
};

struct DisplayPictureParams {
  std::optional<AspectFit> fit = {};         ///< none: default_fit()
  ViewFilter filter = ViewFilter::kNearest;  ///< between views; gaussian: native frames only. Arrays: nearest only
  double sigma_views = 0.5;                  ///< of gaussian
  std::optional<FlipParams> flip = {};       ///< sheets only
  bool mirror = false;                       ///< left and right change places, for prints on the back of a sheet
  int turn_deg = 0;                          ///< clockwise: 0, 90, 180 or 270
  double view_shift_px = 0.0;                ///< as ViewFitter has it
  PrintFinish finish = {};                   ///< sheets and arrays only
};

/// The kind of picture: as a format of layout/formats.hpp.
enum class DisplayTarget { kIntegral, kQuilt, kNative };

/// Throws a usage Error naming `display` if the display has no such picture. `format`: integral, quilt or native.
DisplayTarget display_target(const Display& display, std::string_view format);

/// Stretch for native frames, whose views are then sampled at their own size, as players of panels do; crop for the others.
AspectFit default_fit(DisplayTarget target);

/// The format of the display's own picture: native for slanted panels, integral for the others.
std::string_view own_format(const Display& display);

/// Fits views, one at a time, to what a display resolves.
class ViewFitter {
 public:
  /// view_shift_px moves the zero plane: the window that is shown moves to the right by so many pixels of a view from each
  /// column to the next, around the middle of all, and up likewise from row to row. Above 0 the scene comes forward. Cropped
  /// and stretched views keep only what the shifts leave of all of them; padded ones get black edges.
  ///
  /// The arguments must outlive this object. Throws a usage Error for strips below 2 pixels or wider than the picture.
  ViewFitter(const Display& display, DisplayTarget target, AspectFit fit, const ThreadPool& pool, double view_shift_px = 0.0);

  /// `aspect`: of the scene that the view shows, width / height. `number`: of the view in `grid`, for its shift. Throws Error
  /// if the size is not that of the first view, and a usage Error naming `view-shift` for shifts that leave less than half of
  /// it.
  Picture fitted(const Picture& view, double aspect, int number = 0, ViewGrid grid = {1, 1});
  /// The same for each view of a light field in memory.
  void fit(LightField& field);

  Vec2i size() const { return size_; }
  bool has_fitted() const { return original_.x > 0; }
  /// "cropped from 4000x3000 to 2250x3000, shifted by 1.5 pixels from view to view, resized to 372x682".
  std::string described() const;

 private:
  Vec2d window_of(Vec2i view, double aspect) const;
  Vec2d window_in_all(Vec2i view, double aspect, ViewGrid grid) const;

  const Display& display_;
  DisplayTarget target_;
  AspectFit fit_;
  const ThreadPool& pool_;
  double view_shift_px_;
  Vec2i size_{0, 0};
  double first_ = 0.0, step_ = 1.0;  ///< the display's share of width where the first sample begins, and of each sample
  double aspect_ = 1.0;              ///< of the display
  Vec2i original_{0, 0};
  Vec2d window_{0.0};
};

/// A display that is larger on all sides, whose lenses lie where they were. ViewFitter and display_picture take it in place of
/// the display where DisplayPictureParams::finish has a bleed.
Display with_bleed(const Display& display, double bleed_mm);

/// The picture of the display, of views that a ViewFitter has fitted. Throws a usage Error for views of more than one row, a
/// single view, shares that are not as many as the frames, a finish of what is no print, and a proof
/// of a print that is no larger.
Picture display_picture(const LightField& field, const Display& display, DisplayTarget target,
                        const DisplayPictureParams& params, const ThreadPool& pool);

}  // namespace lippmann
