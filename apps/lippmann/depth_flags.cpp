#include "apps/lippmann/depth_flags.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/printable.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {

void DepthFlags::add_to(FormatOptions& options) const {
  if (!range.empty()) options.depth_range = read_depth_range(range, "--depth-range");
  if (!coding.empty()) options.even_in_depth = coding == "depth";
  if (near_black) options.near_black = true;
}

void add_depth_flags(const Command& command, DepthFlags& flags) {
  const Command group =
      command.add_group("RGB-D pictures", "Convert --from rgbd to the views of --display or --views, or --to rgbd");
  group
      .add_option(
          "--depth", flags.map,
          "A depth map for the picture IN: grey of 8 or 16 bits, of any size, an EXR file with the channel Z, or a HEIC "
          "photo that stores depth, such as IN itself")
      .type_name("FILE");
  group
      .add_option(
          "--depth-range", flags.range,
          "Depths of the nearest and the farthest grey in mm, positive in front of the screen; default with --from rgbd: from "
          "the side file, else 10:-30; default with --to rgbd: the depths of the light field")
      .type_name("NEAR:FAR");
  group.add_option("--depth-coding", flags.coding, "Quantity that is linear in the grey values: disparity (default) or depth")
      .one_of({"disparity", "depth"});
  group.add_flag("--near-black", flags.near_black, "Black is near; default: white is near");
  group.add_option("--depth-scale", flags.scale, "Factor for all depths; default: 1").type_name("X").range(0.0, 100.0);
}

int run_depth_views(const DepthConversion& params, const ResultFlags& result, const Context& context) {
  const ConvertedDepth made = convert_depth_frames(params, context);
  if (result.json) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const auto& path : made.written) files.push_back(path.string());
    print_json(nlohmann::ordered_json{{"views", {made.views.columns, made.views.rows}},
                                      {"view_size", {made.view_size.x, made.view_size.y}},
                                      {"filled_share", made.filled_share},
                                      {"files", files}});
  } else if (result.wants_text() && !made.written.empty()) {
    fmt::print("{}x{} views of {}x{} pixels, {:.2f} % of them filled where nothing is known: {}{}\n", made.views.columns,
               made.views.rows, made.view_size.x, made.view_size.y, 100.0 * made.filled_share,
               printable_line(made.written.front().string()),
               made.written.size() > 1 ? " ... " + printable_line(made.written.back().string()) : "");
  }
  return 0;
}

}  // namespace lippmann::app
