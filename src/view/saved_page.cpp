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
#include "view/preview.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr int kSavedEffort = 2;
/// Attributes of index.html that state where the page gets its data.
constexpr std::string_view kServed = "content=\"server\"", kScripts = "content=\"scripts\"", kWithin = "content=\"within\"";
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{1} << 30;

class PageFolder {
 public:
  explicit PageFolder(const fs::path& folder) : folder_(folder), new_(folder) {}

  void write(const fs::path& name, std::string_view text) {
    if (name.has_parent_path()) make_folder(folder_ / name.parent_path());
    write_file_atomically(folder_ / name, std::as_bytes(std::span(text)));
    bytes_ += text.size();
    files_.push_back(folder_ / name);
  }

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

/// Throws Error if the file exists and is not a saved page, because saving would replace it.
void require_own_page(const fs::path& file, std::string_view mark, const char* accepted) {
  if (!is_regular_file_there(file)) return;
  if (read_file_text(file, kMaxFileBytes, "a page that was saved before").find(mark) == std::string::npos)
    throw Error(file.string(), "exists and is not a page of lippmann view, so it is not replaced", accepted);
}

void replace_once(std::string& text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw Error("index.html", fmt::format("{} is missing in the embedded page", from));
  text.replace(at, from.size(), to);
}

std::string saved_index(std::string_view source) {
  std::string text(page_files().front().text);
  replace_once(text, kServed, source);
  return text;
}

std::string_view text_of_page_file(std::string_view name) {
  for (const PageFile& file : page_files())
    if (file.name == name) return file.text;
  throw Error(std::string(name), "is not a file of the embedded page");
}

/// Any closing tag would end a script element, even within a string. In JavaScript and JSON strings, `<\/` means `</`.
std::string within_script(std::string_view text) {
  std::string safe;
  for (std::size_t i = 0; i < text.size(); ++i) {
    safe += text[i];
    if (text.substr(i).starts_with("</script") || text.substr(i).starts_with("<!--")) safe += '\\';
  }
  return safe;
}

/// Returns whether the page needs this image. The page needs the panel's image only if it cannot derive it from the views.
bool needs(const PageFacts& facts, std::string_view kind, std::size_t frame) {
  if (kind == "preview") return frame == 0 && preview_view_size(facts);
  if (kind == "depth") return facts.has_depth;
  if (kind == "provenance") return facts.has_provenance;
  return kind == "views" || facts.panel == PanelPicture::kOwn;
}

/// Calls write(name, image) for each image. Returns false if cancelled.
template <class Write>
bool make_pictures(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context, const FrameSaved& saved,
                   const Write& write) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const PageFacts& facts = fields[i]->facts();
    for (std::size_t frame = 0; frame < facts.frames.size(); ++frame) {
      for (const std::string_view kind : {"preview", "views", "depth", "provenance", "panel"}) {
        if (context.cancelled) return false;
        if (needs(facts, kind, frame))
          write(fmt::format("{}/{}/{}", i, kind, frame), page_picture(*fields[i], kind, frame, kSavedEffort));
      }
      if (saved) saved(facts.frames[frame].label);
    }
  }
  return true;
}

}  // namespace

SavedPage save_page(const std::vector<std::unique_ptr<PageField>>& fields, const fs::path& folder, const Context& context,
                    const FrameSaved& saved) {
  require_own_page(folder / "index.html", kScripts, "a new folder, or one of a page that was saved before");
  PageFolder page(folder);
  const auto write = [&](const std::string& name, const PagePicture& picture) { page.write_picture(name, picture); };
  if (!make_pictures(fields, context, saved, write)) return {};
  page.write("fields.js", "lippmann_fields(" + fields_text(fields) + ")\n");
  for (const PageFile& file : page_files())
    if (file.name != "index.html") page.write(fs::path(file.name), file.text);
  page.write("index.html", saved_index(kScripts));
  return {page.path() / "index.html", page.bytes(), page.files()};
}

std::string page_as_file(const std::vector<std::unique_ptr<PageField>>& fields, const Context& context,
                         const FrameSaved& saved) {
  std::string text = saved_index(kWithin);
  const std::size_t end_of_body = text.rfind("</body>");
  if (end_of_body == std::string::npos) throw Error("index.html", "has no </body> in the embedded page");
  const std::string end = text.substr(end_of_body);
  text.resize(end_of_body);
  replace_once(text, R"(<link rel="stylesheet" href="./app.css" />)",
               fmt::format("<style>{}</style>", text_of_page_file("app.css")));
  replace_once(text, R"(<script defer src="./app.js"></script>)", "");
  text += fmt::format("<script type=\"application/json\" id=\"data:fields\">{}</script>\n", within_script(fields_text(fields)));
  const auto append = [&](const std::string& name, const PagePicture& picture) {
    text += fmt::format("<script type=\"text/plain\" id=\"data:{}\" data-type=\"{}\">{}</script>\n", name, picture.type,
                        base64(picture.bytes));
    if (text.size() > kMaxFileBytes)
      throw Error("The page", "would be larger than 1 GB as one file", "a page saved as a folder: `lippmann view` with `save`");
  };
  if (!make_pictures(fields, context, saved, append)) return {};
  return text + fmt::format("<script>{}</script>\n", within_script(text_of_page_file("app.js"))) + end;
}

SavedPage save_page_file(const std::vector<std::unique_ptr<PageField>>& fields, const fs::path& file, const Context& context,
                         const FrameSaved& saved) {
  require_own_page(file, kWithin, "a new file, or a page that was saved before");
  const std::string text = page_as_file(fields, context, saved);
  if (text.empty()) return {};
  write_file_atomically(file, std::as_bytes(std::span(text)));
  return {file, text.size(), {file}};
}

SavedPage save_page(const fs::path& in, const fs::path& folder, const Context& context) {
  std::vector<std::unique_ptr<PageField>> fields;
  fields.push_back(std::make_unique<PageField>(in, LightFieldHints{}, context));
  return save_page(fields, folder, context);
}

}  // namespace lippmann
