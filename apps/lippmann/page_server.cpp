#include "apps/lippmann/page_server.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <thread>
#include <utility>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/print.hpp"
#include "core/platform.hpp"
#include "view/http_server.hpp"

namespace lippmann::app {
namespace {

/// Makes the first preview while the user opens the page.
class EarlyPreview {
 public:
  explicit EarlyPreview(PageAnswers& answers) : thread_([&answers] { make(answers); }) {}
  ~EarlyPreview() { thread_.join(); }
  EarlyPreview(const EarlyPreview&) = delete;
  EarlyPreview& operator=(const EarlyPreview&) = delete;

 private:
  static void make(PageAnswers& answers) {
    try {
      answers.make_first_preview();
    } catch (const std::exception&) {
      // The answer to the page's request states the error.
    }
  }

  std::thread thread_;
};

int serve(HttpServer& server, PageAnswers& answers, const std::string& token, const PageServerFlags& flags,
          const Context& context) {
  const EarlyPreview preview(answers);
  const std::string address = page_address(flags.host, server.port(), token);
  fmt::print("{}\n", address);
  std::fflush(stdout);
  print_error("Open this address in a browser; Ctrl-C ends it.\n");
  if (flags.open && !platform::open_in_browser(address)) print_error("no browser could be started; the address is above\n");
  server.run(answers, context.cancelled);
  return 0;
}

}  // namespace

void add_page_server_flags(const Command& command, PageServerFlags& flags) {
  command
      .add_option("--port", flags.port, "Port of the server; 0: any free port; default: 8488, or any free port if it is taken")
      .type_name("N")
      .range(0, 65535);
  command
      .add_option("--host", flags.host,
                  "Address to listen at; if other machines can reach it, the printed address contains a secret token")
      .type_name("ADDRESS")
      .show_default();
  command.add_flag("--open", flags.open, "Open the page in the browser");
}

int serve_page(std::vector<std::unique_ptr<PageField>> fields, std::optional<PageDisplay> display, const PageServerFlags& flags,
               const Context& context) {
  HttpServer server(flags.host, flags.port);
  const std::string token = is_loopback(flags.host) ? "" : random_token();
  PageAnswers answers(std::move(fields), {page_hosts(flags.host, server.port()), token}, std::move(display));
  return serve(server, answers, token, flags, context);
}

int serve_page(std::unique_ptr<LivePage> live, const PageServerFlags& flags, const Context& context) {
  HttpServer server(flags.host, flags.port);
  const std::string token = random_token();
  PageAnswers answers(std::move(live), {page_hosts(flags.host, server.port()), token});
  return serve(server, answers, token, flags, context);
}

int serve_page(std::shared_ptr<DroppedPictures> dropped, const PageServerFlags& flags, const Context& context) {
  HttpServer server(flags.host, flags.port);
  const std::string token = random_token();
  PageAnswers answers(std::move(dropped), {page_hosts(flags.host, server.port()), token});
  return serve(server, answers, token, flags, context);
}

int serve_page(std::unique_ptr<PageField> field, std::shared_ptr<RunningRender> render, const PageServerFlags& flags,
               const Context& context) {
  HttpServer server(flags.host, flags.port);
  const std::string token = random_token();
  PageAnswers answers(std::move(field), std::move(render), {page_hosts(flags.host, server.port()), token});
  return serve(server, answers, token, flags, context);
}

}  // namespace lippmann::app
