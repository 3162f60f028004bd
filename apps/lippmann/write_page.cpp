#include "apps/lippmann/write_page.hpp"

#include "folder/render_folder.hpp"

namespace lippmann::app {

SavedPage write_page(const std::filesystem::path& folder, const Context& context) {
  RenderFolder render(folder, read_journal(folder).value_or(FolderJournal{}).job);
  SavedPage page = save_page(folder, folder / kPageFolder, context);
  if (!page.index.empty()) render.add_page(page.files);
  return page;
}

}  // namespace lippmann::app
