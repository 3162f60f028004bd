// Commands that show a page in the browser: the flags of their server, and what runs it.
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

/// Prints the page's address, and answers until it is interrupted. `display`: what the first light field is played on. A live
/// scene has a token in its address on this machine, too: nobody else who works on it can change anything.
int serve_page(std::unique_ptr<LivePage> live, const PageServerFlags& flags, const Context& context);
int serve_page(std::vector<std::unique_ptr<PageField>> fields, std::optional<PageDisplay> display, const PageServerFlags& flags,
               const Context& context);
/// A page on which pictures are dropped: its address has a token, too.
int serve_page(std::shared_ptr<DroppedPictures> dropped, const PageServerFlags& flags, const Context& context);
/// A render that may be stopped and resumed from the page: its address has a token, too.
int serve_page(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, const PageServerFlags& flags,
               const Context& context);

}  // namespace lippmann::app
