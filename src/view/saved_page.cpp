#include "view/saved_page.hpp"

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

#include "core/atomic_file.hpp"
#include "core/base64.hpp"
#include "core/folder.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"
#include "view/answers.hpp"
#include "view/page_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Pictures are made once and fetched often.
constexpr int kSavedEffort = 2;
/// In index.html: where its data come from.
constexpr std::string_view kServed = "content=\"server\"", kScripts = "content=\"scripts\"";

class PageFolder {
 public:
  explicit PageFolder(const fs::path& folder) : folder_(folder), new_(folder) {}

  void write(const fs::path& name, std::string_view text) {
    if (name.has_parent_path()) make_folder(folder_ / name.parent_path());
    write_file_atomically(folder_ / name, std::as_bytes(std::span(text)));
    bytes_ += text.size();
    files_.push_back(folder_ / name);
  }

  /// A script that gives the page what it would ask a server for.
  void write_picture(std::string_view name, const PagePicture& picture) {
    write(fmt::format("{}.js", name),
          fmt::format("lippmann_data(\"{}\",\"{}\",\"{}\")\n", name, picture.type, base64(picture.bytes)));
  }

  fs::path path() const { return folder_; }
  std::uintmax_t bytes() const { return bytes_; }
  std::vector<fs::path> files() const { return files_; }

 private:
  fs::path folder_;
  NewFolder new_;
  std::uintmax_t bytes_ = 0;
  std::vector<fs::path> files_;
};

/// Somebody else's page stays.
void require_own_page(const fs::path& folder) {
  constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;
  const fs::path file = folder / "index.html";
  if (!is_regular_file_there(file)) return;
  if (read_file_text(file, kMostBytes, "a page that was saved before").find(kScripts) == std::string::npos)
    throw Error(file.string(), "is another page, and would be replaced",
                "a new folder, or one of a page that was saved before");
}

std::string saved_index(std::string_view served) {
  std::string text(served);
  const std::size_t at = text.find(kServed);
  if (at == std::string::npos) throw Error("index.html", "of this program does not say where its data come from");
  return text.replace(at, kServed.size(), kScripts);
}

/// Whether a saved page has pictures of that kind: the panel's own where it does not follow from the views.
bool needs(const PageFacts& facts, std::string_view kind) {
  if (kind == "depth") return facts.has_depth;
  if (kind == "provenance") return facts.has_provenance;
  return kind == "views" || facts.panel == PanelPicture::kOwn;
}

}  // namespace

SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const fs::path& folder, const Context& context) {
  require_own_page(folder);
  PageFolder page(folder);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const PageFacts& facts = fields[i]->facts();
    for (std::size_t frame = 0; frame < facts.frames.size(); ++frame)
      for (const std::string_view kind : {"views", "depth", "provenance", "panel"}) {
        if (context.cancelled) return {};
        if (needs(facts, kind))
          page.write_picture(fmt::format("{}/{}/{}", i, kind, frame), page_picture(*fields[i], kind, frame, kSavedEffort));
      }
  }
  page.write("fields.js", "lippmann_fields(" + fields_text(fields) + ")\n");
  for (const PageFile& file : page_files())
    if (file.name != "index.html") page.write(fs::path(file.name), file.text);
  page.write("index.html", saved_index(page_files().front().text));
  return {page.path() / "index.html", page.bytes(), page.files()};
}

SavedPage save_page(const fs::path& in, const fs::path& folder, const Context& context) {
  std::vector<std::unique_ptr<PageField>> fields;
  fields.push_back(std::make_unique<PageField>(in, LightFieldHints{}, context));
  return save_page(fields, folder, context);
}

}  // namespace lippmann
