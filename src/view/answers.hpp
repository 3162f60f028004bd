// Answers the HTTP requests of a page, without sockets.
//
// Requests name images by number, and text of a request never becomes part of a file path. Requests are refused if they come
// from pages of other origins, are for another host (DNS rebinding), or lack the token.
#pragma once

#include <filesystem>
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
  std::string path = "/";  ///< decoded, without the query
  /// Headers Host, Origin and Sec-Fetch-Site; empty if missing.
  std::string host = {}, origin = {}, fetch_site = {};
  bool accepts_gzip = false;
  std::string body = {};
};

struct PageAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  Bytes body = {};
  std::string coding = {};  ///< header Content-Encoding; empty: none
};

struct PageAccess {
  std::vector<std::string> hosts = {};  ///< accepted Host headers, with port; empty: any, because the token protects the server
  std::string token = {};               ///< secret that must be the first part of all paths; empty: none
};

/// Answers requests below "live/" of a page that sets up a scene. Thread-safe.
class LivePage {
 public:
  virtual ~LivePage() = default;

  virtual nlohmann::ordered_json field() const = 0;  ///< description of the light field, as by field_json()
  virtual nlohmann::ordered_json about() const = 0;  ///< facts that are sent to the page once
  virtual InterlaceParams interlace() const = 0;     ///< how views are interlaced on panels
  /// Returns the folder of the last render that the page started; nullopt if that render has not finished.
  virtual std::optional<std::filesystem::path> finished_render() const = 0;
  virtual PageAnswer get(std::string_view path) = 0;
  virtual PageAnswer post(std::string_view path, const std::string& body) = 0;
};

class DroppedPictures;  // declared in view/dropped_pictures.hpp
class PagePrints;       // declared in view/page_print.hpp

class PageAnswers {
 public:
  static constexpr std::size_t kDefaultCacheBytes = std::size_t{256} << 20;

  /// Shows light fields, the first of them on the panel `display`. For a single light field whose files hold the views, pages
  /// may request prints (view/page_print.hpp):
  ///   POST print                     PagePrints::make
  ///   GET  print/views/ID, print/panel/ID, print/file/ID
  /// GET page.html returns the page as one file (page_as_file). For renders and scenes, the file has the finished frames.
  PageAnswers(std::vector<std::unique_ptr<PageField>> fields, PageAccess access, std::optional<PageDisplay> display = {},
              std::size_t cache_bytes = kDefaultCacheBytes);

  /// Shows a live scene. Requests that change it need the token and must come from the page itself.
  PageAnswers(std::unique_ptr<LivePage> live, PageAccess access);

  /// Shows a render that is running or was stopped. These requests stop and resume it; they need the token and must come from
  /// the page itself:
  ///   GET  run/state/KNOWN   RunningRender::state_after
  ///   POST run/stop, run/resume
  PageAnswers(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, PageAccess access);

  /// Shows images that are dropped on the page. `access` must have a token, so that no stranger can fill the disk.
  ///   POST drop/...  DroppedPictures::post
  PageAnswers(std::shared_ptr<DroppedPictures> dropped, PageAccess access);

  PageAnswer answer(const PageRequest& request);

  /// Refuses a request before its body is read: for a wrong origin, host or token, or for a POST to a path that accepts no
  /// POST. Returns nullopt for other requests.
  std::optional<PageAnswer> refusal(const PageRequest& request) const;

  /// Makes the preview that a page requests first, so that the page need not wait for it. Does nothing if there is none.
  void make_first_preview();

 private:
  bool takes_text(std::string_view path) const;
  PageAnswer answer_path(const PageRequest& request, std::string_view path);
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
  std::shared_ptr<PagePrints> prints_;
  std::shared_ptr<DroppedPictures> dropped_;
  PageAccess access_;
  std::optional<PageDisplay> display_;
  ByteCache cache_;
};

struct PagePicture {
  std::string bytes, type;
};
/// encoded_picture() and page_picture() return an image as WebP, or as PNG if the image is too large for WebP. effort: 0
/// (fast) to 9 (small). kind: "views", "preview", "depth", "provenance" or "panel". Both functions throw Error.
PagePicture encoded_picture(const Image8& picture, int effort);
PagePicture page_picture(const PageField& field, std::string_view kind, std::size_t frame, int effort);

struct PageOffers {
  bool prints = false, drops = false;
};

/// Returns fields.json: the version, field_json() of each light field, the display, and the services (prints, dropping images).
std::string fields_text(const std::vector<std::unique_ptr<PageField>>& fields, const std::optional<PageDisplay>& display = {},
                        PageOffers offers = {});

}  // namespace lippmann
