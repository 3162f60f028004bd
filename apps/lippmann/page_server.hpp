// Flags and functions for commands that serve a page to a browser.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/answers.hpp"
#include "view/dropped_pictures.hpp"

namespace lippmann::app {

class Command;

struct PageServerFlags {
  std::string host = "127.0.0.1";
  std::optional<int> port;
  bool open = false;
};

void add_page_server_flags(const Command& command, PageServerFlags& flags);

// Each function prints the page's address and serves the page until interrupted. The address contains a secret token if other
// machines can reach it, or if requests of the page can change files or stop work.

/// Serves a page that sets up a scene. The address always contains a token.
int serve_page(std::unique_ptr<LivePage> live, const PageServerFlags& flags, const Context& context);
/// Serves a page that shows light fields. display: the display on which the first light field is played.
int serve_page(std::vector<std::unique_ptr<PageField>> fields, std::optional<PageDisplay> display, const PageServerFlags& flags,
               const Context& context);
/// Serves a page on which pictures can be dropped. The address always contains a token.
int serve_page(std::shared_ptr<DroppedPictures> dropped, const PageServerFlags& flags, const Context& context);
/// Serves a page that can stop and resume a render. The address always contains a token.
int serve_page(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, const PageServerFlags& flags,
               const Context& context);

}  // namespace lippmann::app
