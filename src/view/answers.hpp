// What a page may ask of the server, and the answer to each request: no sockets, no paths of files.
//
// Requests name pictures by numbers; no text of a request ever becomes part of a path. They are refused that come from pages of
// other origins, name another host (a name that somebody made to point here), lack the token, or want parts of a file.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "view/byte_cache.hpp"
#include "view/page_display.hpp"
#include "view/page_field.hpp"
#include "view/running_render.hpp"

namespace lippmann {

struct PageRequest {
  std::string method = "GET";
  std::string path = "/";                               ///< decoded, without what follows a question mark
  std::string host = {}, origin = {}, fetch_site = {};  ///< headers: Host, Origin, Sec-Fetch-Site; empty: missing
  std::string body = {};                                ///< what a POST sends
};

struct PageAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  Bytes body = {};
};

struct PageAccess {
  std::vector<std::string> hosts = {};  ///< that requests may name, with port; empty: any, as the token keeps strangers out
  std::string token = {};               ///< the first part of all paths; empty: none is asked for
};

/// A scene that is set up from the page (live/live_page.hpp): what lies below "live/". Thread-safe.
class LivePage {
 public:
  virtual ~LivePage() = default;

  virtual nlohmann::ordered_json field() const = 0;  ///< field_json
  virtual nlohmann::ordered_json about() const = 0;  ///< what the page is told once
  virtual InterlaceParams interlace() const = 0;     ///< how views are mixed on panels
  virtual PageAnswer get(std::string_view path) = 0;
  virtual PageAnswer post(std::string_view path, const std::string& body) = 0;
};

class DroppedPictures;  // view/dropped_pictures.hpp
class PagePrints;       // view/page_print.hpp

/// Thread-safe.
class PageAnswers {
 public:
  static constexpr std::size_t kDefaultCacheBytes = std::size_t{256} << 20;

  /// `display`: what the first of them is played on, as require_own_frame and require_one_row allow. Of one light field with
  /// plain views, pages may ask for prints (view/page_print.hpp):
  ///   POST print                     PagePrints::make
  ///   GET  print/views/ID, print/panel/ID, print/file/ID
  /// GET page.html answers with the page as one file (page_as_file).
  PageAnswers(std::vector<std::unique_ptr<PageField>> fields, PageAccess access, std::optional<PageDisplay> display = {},
              std::size_t cache_bytes = kDefaultCacheBytes);

  /// Shows a live scene. Without the token, and from pages of no or another origin, nothing of it can be changed.
  PageAnswers(std::unique_ptr<LivePage> live, PageAccess access);

  /// Shows a render that runs or was stopped, which pages may stop and resume under the same conditions: below "run/",
  ///   GET  run/state/KNOWN   RunningRender::state_after
  ///   POST run/stop, run/resume
  PageAnswers(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, PageAccess access);

  /// Shows the pictures that pages drop, and nothing before the first. `access` has a token: nobody else may fill the disk.
  ///   POST drop/...  DroppedPictures::post
  PageAnswers(std::shared_ptr<DroppedPictures> dropped, PageAccess access);

  PageAnswer answer(const PageRequest& request);

  /// The answer to a request that is refused whatever its body is: it comes from elsewhere, lacks the token, or posts where no
  /// text is taken.
  std::optional<PageAnswer> refusal(const PageRequest& request) const;

 private:
  bool takes_text(std::string_view path) const;
  PageAnswer answer_path(std::string_view path);
  PageAnswer answer_text(const PageRequest& request, std::string_view path);
  PageAnswer answer_drop(const PageRequest& request, std::string_view path);
  std::string description() const;
  PageAnswer whole_page() const;
  InterlaceParams interlace() const;
  PageAnswer calibration(const std::string& text) const;
  PageAnswer picture(std::string_view path);
  PageAnswer make_print(const std::string& request);
  PageAnswer print_picture(std::string_view path) const;
  PageAnswer run_state(std::string_view path);
  PageAnswer run_order(std::string_view order);

  std::vector<std::unique_ptr<PageField>> fields_;
  std::unique_ptr<LivePage> live_;
  std::shared_ptr<RunningRender> render_;
  std::shared_ptr<PagePrints> prints_;        ///< null: there are none
  std::shared_ptr<DroppedPictures> dropped_;  ///< null: pages cannot drop any
  PageAccess access_;
  std::optional<PageDisplay> display_;
  ByteCache cache_;
};

/// One of the pictures of a frame: what "views", "preview", "depth", "provenance" or "panel" names, encoded for a page. Throws
/// Error.
struct PagePicture {
  std::string bytes, type;
};
/// effort: 0 (fast) ... 9 (small).
PagePicture encoded_picture(const Image8& picture, int effort);
PagePicture page_picture(const PageField& field, std::string_view kind, std::size_t frame, int effort);

struct PageOffers {
  bool prints = false, drops = false;
};

/// fields.json: the version, what field_json says of each, the display that they are played on, and what the server
/// offers beside them: prints, with the displays that it knows, and to show pictures that are dropped.
std::string fields_text(const std::vector<std::unique_ptr<PageField>>& fields, const std::optional<PageDisplay>& display = {},
                        PageOffers offers = {});

}  // namespace lippmann
