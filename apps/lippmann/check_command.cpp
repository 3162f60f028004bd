// `lippmann check DIR`: compares the files of a rendered folder with their recorded checksums.
#include <fmt/core.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/frame_ranges.hpp"
#include "core/printable.hpp"
#include "folder/folder_check.hpp"
#include "job/params.hpp"

namespace lippmann::app {
namespace {

struct Options {
  std::string folder;
  ResultFlags result;
};

void print_text(const std::string& folder, const FolderCheck& check) {
  for (const auto& [kind, names] :
       {std::pair("damaged", check.damaged), std::pair("missing", check.missing), std::pair("foreign", check.foreign)})
    for (const std::string& name : names) fmt::print("{}  {}\n", kind, printable_line(name));
  const std::string unfinished = write_frames(ranges_of(check.unfinished));
  if (!unfinished.empty()) fmt::print("not rendered yet: frames {}\n", unfinished);
  for (const auto& [name, frames] : check.unfinished_beside)
    fmt::print("not rendered yet: frames {} in {}\n", write_frames(ranges_of(frames)), printable_line(name));
  for (const auto& [frame, strips] : check.strips_left)
    fmt::print("not rendered yet: strips {} of frame {}\n", write_frames(ranges_of(strips)), frame);
  if (!check.joinable.empty())
    fmt::print("not joined yet: the strips of frames {} ('lippmann finish' does it)\n",
               write_frames(ranges_of(check.joinable)));
  fmt::print("{}: {} files, {} frame{}; {} damaged, {} missing, {} foreign\n", printable_line(folder), check.files,
             check.frames, check.frames == 1 ? "" : "s", check.damaged.size(), check.missing.size(), check.foreign.size());
}

/// Returns a JSON object that maps each frame or folder to its numbers, written as ranges: {"0": "2,5-7"}.
template <class Key>
nlohmann::ordered_json numbers_json(const std::map<Key, std::vector<int>>& numbers) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [key, some] : numbers) json[fmt::format("{}", key)] = write_frames(ranges_of(some));
  return json;
}

int run(const Options& options) {
  const FolderCheck check = check_folder(options.folder);
  if (options.result.json)
    print_json({{"folder", options.folder},
                {"frames", check.frames},
                {"files", check.files},
                {"damaged", check.damaged},
                {"missing", check.missing},
                {"foreign", check.foreign},
                {"unfinished", check.unfinished},
                {"unfinished_beside", numbers_json(check.unfinished_beside)},
                {"strips_left", numbers_json(check.strips_left)},
                {"passed", check.passed()}});
  else if (options.result.wants_text())
    print_text(options.folder, check);
  return check.passed() ? 0 : 1;
}

}  // namespace

void add_check_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<Options>();
  const Command command = root.add_command("check", "Find files of a rendered folder that are damaged, missing or foreign");
  command.add_option("DIR", options->folder, "The folder that a render wrote to").required();
  add_result_flags(command, options->result, "Print nothing: exit code 0 means that all files are intact");
  command.footer(
      "A render records the size and checksum of every picture, layer, side file and video, of job.toml and report.json, and\n"
      "of the page and the single view beside them (--page, --also).\n"
      "  damaged   its bytes have changed\n"
      "  missing   it does not exist\n"
      "  foreign   it is named like the file of a frame, but belongs to no frame of this render\n"
      "The exit code is 1 if there is such a file or if frames of the job are not rendered yet, else 0.\n"
      "'lippmann render DIR/job.toml --resume' renders again what is damaged, missing or not rendered yet.\n");
  command.when_named([options, &chosen] { chosen = [options](Context&) { return run(*options); }; });
}

}  // namespace lippmann::app
