// Renders jobs into folders of a test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "folder/folder_check.hpp"
#include "job/animation.hpp"
#include "job/job_file.hpp"
#include "job/params_table.hpp"
#include "lippmann/formats/convert.hpp"
#include "support/error_message.hpp"
#include "support/folder_files.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {

using Settings = std::vector<std::pair<std::string, std::string>>;

inline Settings operator+(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class Renders : public testing::Test {
 protected:
  Renders() {
    context_.threads = 2;
    context_.warn = [this](std::string_view text) { warnings_.append(text).append("\n"); };
  }

  /// `scene` is a built-in scene or a file in the test's folder.
  RenderParams job(const std::string& scene, const std::string& folder, const Settings& settings) const {
    RenderParams params;
    params.scene.name = scene;
    params.output.folder = dir_ / folder;
    for (const auto& [key, value] : settings) find_param(key)->set(params, {value}, key);
    return params;
  }

  RenderParams teapot(const std::string& folder, const std::string& frames, const Settings& settings = {}) const {
    return job("teapot", folder, Settings{{"lenses", "16"}, {"frames", frames}} + settings);
  }

  RenderParams job_of(const std::string& folder) const {
    RenderParams params;
    read_job(dir_ / folder / "job.toml", params);
    return params;
  }

  RenderReport render(const RenderParams& params, const RunParams& run = {}) {
    warnings_.clear();
    return render_animation(ResolvedJob(params), context_, {}, run);
  }

  Files rendered(const RenderParams& params) {
    render(params);
    return files_in(params.output.folder, ".png");
  }

  static std::size_t kept(const RenderReport& report) {
    std::size_t count = 0;
    for (const FrameReport& frame : report.frames) count += frame.kept ? 1 : 0;
    return count;
  }

  RenderReport resume(RenderParams params) {
    params.resume = true;
    return render(params);
  }

  std::string refusal(const RenderParams& params, const RunParams& run = {}) {
    return error_message([&] { render(params, run); });
  }

  FolderCheck check(const std::string& folder) const { return check_folder(dir_ / folder); }

  Converted convert(const std::string& in, const std::string& out, const std::string& to, ConvertParams params = {}) const {
    params.to = to;
    return lippmann::convert(dir_ / in, dir_ / out, params);
  }

  std::string bytes(const std::string& file) const { return file_bytes(dir_ / file); }
  bool exists(const std::string& file) const { return std::filesystem::exists(dir_ / file); }

  TempDir dir_;
  std::string warnings_;
  Context context_;
};

}  // namespace lippmann::test
