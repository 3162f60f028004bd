#include "view/within_folder.hpp"

#include <algorithm>
#include <string>

#include "folder/journal.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

bool leads_out(const fs::path& root, const fs::path& file) {
  std::error_code problem;
  const fs::path real = fs::weakly_canonical(file, problem);
  if (problem) return true;
  return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first != root.end();
}

[[noreturn]] void refuse(const fs::path& root, const fs::path& file) {
  throw Error(file.string(), "is a link that leads out of " + root.string(), "files inside the shown folder");
}

/// Throws if a link whose name satisfies `concerns` leads out of `root`.
template <class Concerns>
void require_links_within(const fs::path& root, const fs::path& folder, const Concerns& concerns) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_symlink(ignored) && concerns(entry.path().filename()) && leads_out(root, entry.path()))
      refuse(root, entry.path());
}

/// True for report.json, job.toml, cameras.json, parameters.cfg and side files.
bool is_description(const fs::path& name) {
  const std::string extension = name.extension().string();
  return extension == ".json" || extension == ".toml" || extension == ".cfg";
}

/// True for side files and layers of the picture, such as frame_0000.png.json or aov_0000.exr.
bool is_read_with(const fs::path& picture, const std::string& name) {
  const std::string stem = picture.stem().string();
  const std::size_t digits = std::min(stem.find_first_of("0123456789"), stem.size());
  const std::string number = stem.substr(digits, stem.find_first_not_of("0123456789", digits) - digits);
  return name.starts_with(stem + ".") || name.starts_with(stem + "_") || name.starts_with("aov_" + number);
}

/// Checks the reports that are read with `file`, also those in the two folders above it, which may be outside `root`. A report
/// may be a link to a file in its own folder.
void require_reports_within(const fs::path& root, const fs::path& file) {
  const fs::path parent = file.parent_path();
  for (const fs::path& folder : {file, parent, parent.parent_path()}) {
    const fs::path report = folder / "report.json";
    std::error_code ignored;
    if (fs::is_symlink(report, ignored) && leads_out(root, report) && leads_out(fs::weakly_canonical(folder, ignored), report))
      refuse(root, report);
  }
}

/// Checks reports, job files and other descriptions of `in`. The frames of a folder are checked when they are read.
void require_descriptions_within(const fs::path& root, const fs::path& in) {
  require_reports_within(root, in);
  std::error_code ignored;
  if (!fs::is_directory(in, ignored)) return require_within(root, in);
  require_links_within(root, in, is_description);
  require_links_within(root, journal_folder(in), [](const fs::path&) { return true; });
}

}  // namespace

fs::path shown_root(const fs::path& in) {
  std::error_code problem;
  const fs::path real = fs::canonical(in, problem);
  if (problem) throw Error(in.string(), "there is no such file or folder");
  const fs::path root = fs::is_directory(real, problem) ? real : real.parent_path();
  const fs::path whole = fs::absolute(in).lexically_normal();
  require_descriptions_within(root, whole.has_filename() ? whole : whole.parent_path());
  return root;
}

void require_within(const fs::path& root, const fs::path& file) {
  if (leads_out(root, file)) refuse(root, file);
  const fs::path whole = fs::absolute(file).lexically_normal();
  require_reports_within(root, whole);
  require_links_within(root, whole, [](const fs::path&) { return true; });
  if (leads_out(root, whole.parent_path())) return;
  require_links_within(root, whole.parent_path(), [&](const fs::path& name) { return is_read_with(whole, name.string()); });
}

}  // namespace lippmann
