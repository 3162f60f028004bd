// Makes prints for a page from the views of a frame: the image for a display, as `lippmann convert` makes it, and the views
// that eyes see of it through the display's lenses. Keeps only the last print. Thread-safe.
#pragma once

#include <memory>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lippmann/layout/display_picture.hpp"
#include "view/byte_cache.hpp"
#include "view/page_field.hpp"

namespace lippmann {

/// An A4 page at 1000 dpi has 97 million pixels. A print takes 15 bytes of memory per pixel.
inline constexpr double kMaxPrintPixels = 100e6;

struct PrintRequest {
  std::size_t frame = 0;
  Display display;
  std::optional<AspectFit> fit = {};  ///< none: default_fit()
  double view_shift_px = 0.0;
};

/// Parses {"frame", "display", "file": {"name", "text"}, "fit", "view_shift_px"}. The display is a name, the one-line
/// description of a sheet, or the text of a file, but never a path. Throws Error naming the key.
PrintRequest read_print_request(const std::string& text);

class PagePrints {
 public:
  /// `field` must outlive this object. Requires field.has_plain_views().
  explicit PagePrints(const PageField& field);

  /// Makes a print. Returns JSON with the keys `id`, `description`, `fitted` (how the views were fitted), `pixels` and `field`
  /// (the light field that eyes see of the print). Throws Error.
  nlohmann::ordered_json make(const std::string& request);

  /// Returns an image of the print `id`, or null if there is no such print. kind: "views" (what eyes see of the print),
  /// "panel", or "file" (the print itself).
  Bytes picture(std::string_view kind, std::size_t id) const;
  bool is_outdated(std::size_t id) const;

 private:
  struct Print;
  std::shared_ptr<const Print> kept() const;

  const PageField& field_;
  ThreadPool pool_;
  std::mutex making_;
  mutable std::mutex mutex_;  ///< guards the members below
  std::shared_ptr<const Print> last_;
  std::size_t made_ = 0;
};

}  // namespace lippmann
