// A light field in files, as a page shows it: a description and, for each frame, the quilt of the views, their disparities if
// depth is known, and the panel's image. Reads every input that find_light_field_frames accepts.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lippmann/core/parallel.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

class RunningRender;

class PageField {
 public:
  /// Throws Error naming the file, or the flag that must supply missing information. Depth that cannot be read is left out with
  /// a warning. Links that lead out of the folder are refused.
  PageField(std::filesystem::path in, LightFieldHints hints, const Context& context);

  /// Opens a render in progress, whose report describes the optics and the layers. Throws Error naming the report. Reading an
  /// unfinished frame throws Error.
  PageField(const std::filesystem::path& folder, std::shared_ptr<const RunningRender> coming, const Context& context);

  const PageFacts& facts() const { return facts_; }
  void set_title(std::string title) { facts_.title = std::move(title); }

  // The following functions return images of the frame with index `frame`. They throw Error naming the file, and are
  // thread-safe.

  /// The views as a quilt in sRGB codes. crosstalk_px: see views_quilt().
  Image8 quilt(std::size_t frame, double crosstalk_px = 0.0) const;
  /// The disparity codes of the views as a quilt. Needs facts().has_depth.
  Image8 disparities(std::size_t frame) const;
  /// The Provenance number of each pixel in red, green and blue, as a quilt. Needs facts().has_provenance.
  Image8 provenance(std::size_t frame) const;
  Image8 panel(std::size_t frame) const;
  /// Returns the views with the samples stored in the files. Needs has_plain_views(). fit: as FormatOptions::fit_view.
  LightField views(std::size_t frame,
                   const std::function<Picture(const Picture&, double aspect, int view, ViewGrid grid)>& fit) const;

  /// True if the files hold two or more views with all their pixels.
  bool has_plain_views() const;
  int threads() const { return pool_.threads(); }

 private:
  RenderedPanel read(std::size_t frame) const;
  std::filesystem::path file_of(std::size_t frame) const;
  struct Layered;
  Layered layered(std::size_t frame) const;
  void find_layers();
  Image8 in_quilt(const Image8& stack) const;

  LightFieldHints hints_;
  std::filesystem::path root_;  ///< frames outside this folder are refused
  LightFieldFrames frames_;
  PageFacts facts_;
  ThreadPool pool_;
  std::shared_ptr<const RunningRender> coming_;
};

}  // namespace lippmann
