// A light field in files, as a page shows it: its description and, for each frame, the quilt of its views, the disparities if
// depth is known, and the panel's image.
//
// Reads everything that find_light_field_frames reads.
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
  /// Throws Error naming the file, or a flag that must supply missing information. Depth that cannot be read is omitted with a
  /// warning. Links that lead out of the folder are refused; links of frames when the frame is read.
  PageField(std::filesystem::path in, LightFieldHints hints, const Context& context);

  /// Shows a render in progress. Its report has the optics and the available layers. Throws Error naming the report. Reading a
  /// frame that is not finished throws Error.
  PageField(const std::filesystem::path& folder, std::shared_ptr<const RunningRender> coming, const Context& context);

  const PageFacts& facts() const { return facts_; }
  /// Replaces the title, which is the file name by default.
  void set_title(std::string title) { facts_.title = std::move(title); }

  // Images of the frame with that index, below facts().frames.size(). Each throws Error naming the file. Thread-safe.

  /// Returns the views in sRGB codes, facts().tiles of facts().view_size. crosstalk_px: see views_quilt().
  Image8 quilt(std::size_t frame, double crosstalk_px = 0.0) const;
  /// Returns the disparity codes of the views as a quilt. Needs facts().has_depth.
  Image8 disparities(std::size_t frame) const;
  /// Returns the provenance of each pixel as a quilt, its number in Provenance in red, green and blue. Needs
  /// facts().has_provenance.
  Image8 provenance(std::size_t frame) const;
  /// Returns the panel's image in sRGB codes, facts().panel_size.
  Image8 panel(std::size_t frame) const;
  /// Returns the views with the samples of the files. Needs has_plain_views(). fit: as FormatOptions::fit_view.
  LightField views(std::size_t frame, const std::function<Picture(const Picture&, int view, ViewGrid grid)>& fit) const;

  /// Returns whether the files contain complete pixels of two or more views.
  bool has_plain_views() const;
  int threads() const { return pool_.threads(); }

 private:
  RenderedPanel read(std::size_t frame) const;
  std::filesystem::path file_of(std::size_t frame) const;
  /// The views with all their layers.
  struct Layered;
  Layered layered(std::size_t frame) const;
  /// Sets the facts about layers from the first frame.
  void find_layers();
  Image8 in_quilt(const Image8& stack) const;

  LightFieldHints hints_;
  std::filesystem::path root_;  ///< frames outside this folder are refused unread
  LightFieldFrames frames_;
  PageFacts facts_;
  ThreadPool pool_;
  std::shared_ptr<const RunningRender> coming_;  ///< null: all files exist
};

}  // namespace lippmann
