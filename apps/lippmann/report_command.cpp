// `lippmann report IN...`: writes the figures of renders and benchmarks as one HTML page.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "report/report_page.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::vector<std::string> in;
  std::string output;
  ResultFlags result;
};

void print_written(const ReportOptions& options, const ReportPage& page, const fs::path& file) {
  if (options.result.json)
    print_json({{"page", file.string()}, {"bytes", page.html.size()}, {"missing", page.missing}});
  else if (options.result.wants_text())
    fmt::print("{}: {:.2f} MB\n", printable_line(file.string()), 1e-6 * double(page.html.size()));
}

int run(const ReportOptions& options, const Context& context) {
  const std::vector<fs::path> inputs(options.in.begin(), options.in.end());
  const fs::path file = options.output.empty() ? default_report_file(inputs) : fs::path(options.output);
  const ReportPage page = make_report_page(inputs, context);
  if (context.cancelled) return 1;
  for (const std::string& sentence : page.missing) context.warning(sentence);
  write_report_page(page, file);
  print_written(options, page, file);
  return 0;
}

}  // namespace

void add_report_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<ReportOptions>();
  const Command command = root.add_command(
      "report", "Write an HTML page of a render's figures, or of several renders side by side, that opens without a server");
  command
      .add_option("IN", options->in,
                  "The folder of a render, its report.json, or the output of `lippmann-bench --json`; several are compared")
      .required();
  command
      .add_option("-o,--output", options->output,
                  "The page; default: report.html in the folder of a single render, else in the working folder")
      .type_name("FILE.html");
  add_result_flags(command, options->result);
  command.footer(
      "Examples:\n"
      "  lippmann report out/teapot                                  out/teapot/report.html\n"
      "  lippmann report out/traced out/copied -o compared.html      what reuse saves, frame by frame\n"
      "  lippmann-bench reuse --json > reuse.json && lippmann report reuse.json\n");
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
