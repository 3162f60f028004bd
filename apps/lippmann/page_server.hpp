// The flags and the server of commands that show a page in the browser.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/context.hpp"
#include "view/answers.hpp"
#include "view/dropped_pictures.hpp"

namespace lippmann::app {

class Command;  // command_line.hpp

struct PageServerFlags {
  std::string host = "127.0.0.1";
  std::optional<int> port;
  bool open = false;
};

void add_page_server_flags(const Command& command, PageServerFlags& flags);

/// Prints the page's address and serves the page until interrupted. display: the display on which the first light field is
/// played. The address of a live scene contains a token even if only this machine can reach it, so that other users of the
/// machine cannot change the scene.
int serve_page(std::unique_ptr<LivePage> live, const PageServerFlags& flags, const Context& context);
int serve_page(std::vector<std::unique_ptr<PageField>> fields, std::optional<PageDisplay> display, const PageServerFlags& flags,
               const Context& context);
/// Serves a page on which pictures can be dropped. Its address always contains a token, too.
int serve_page(std::shared_ptr<DroppedPictures> dropped, const PageServerFlags& flags, const Context& context);
/// Serves a page that can stop and resume a render. Its address always contains a token, too.
int serve_page(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, const PageServerFlags& flags,
               const Context& context);

}  // namespace lippmann::app
