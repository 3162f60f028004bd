#include "view/dropped_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/folder_entries.hpp"
#include "core/json_fields.hpp"
#include "core/json_text.hpp"
#include "core/printable.hpp"
#include "core/scratch_folder.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr double kMiB = 1 << 20;

std::string lower_ending(const std::string& name) {
  std::string ending = fs::path(name).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

template <class Number>
std::optional<Number> whole_number(std::string_view digits) {
  Number number = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::vector<std::size_t> ranks_of(const std::vector<std::string>& names) {
  std::vector<std::size_t> order(names.size()), ranks(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return natural_less(names[a], names[b]); });
  for (std::size_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = rank;
  return ranks;
}

}  // namespace

struct DroppedPictures::Received {
  ScratchFolder folder;
  std::string title;
  std::vector<std::string> names;
  std::vector<fs::path> files;  ///< stored files, in the order of `names`
  std::vector<std::uintmax_t> sizes;
  std::uintmax_t bytes = 0;

  std::string with_page_names(std::string message) const {
    for (std::size_t i = 0; i < files.size(); ++i) {
      replace_all(message, files[i].string(), printable(names[i]));
      replace_all(message, files[i].filename().string(), printable(names[i]));
    }
    replace_all(message, folder.path().string(), printable(title));
    return message;
  }
};

/// The folder of the images is kept as long as this object.
struct DroppedPictures::Shown {
  Shown(std::shared_ptr<const Received> from, std::unique_ptr<PageField> field)
      : received(std::move(from)), answers(list_of(std::move(field)), PageAccess{}) {}

  static std::vector<std::unique_ptr<PageField>> list_of(std::unique_ptr<PageField> field) {
    std::vector<std::unique_ptr<PageField>> list;
    list.push_back(std::move(field));
    return list;
  }

  std::shared_ptr<const Received> received;
  PageAnswers answers;
};

DroppedPictures::DroppedPictures(const Context& context, std::uintmax_t most_bytes)
    : context_(context), most_bytes_(most_bytes) {}

DroppedPictures::~DroppedPictures() = default;

void DroppedPictures::post(std::string_view path, const std::string& body) {
  const std::lock_guard lock(receiving_);
  if (path == "begin") return begin(body);
  if (!received_) throw Error("The dropped pictures", "were replaced by those of another page", "dropping the pictures again");
  if (path == "show") return show();
  append(path, body);
}

void DroppedPictures::begin(const std::string& body) {
  received_.reset();
  const nlohmann::ordered_json json = json_from_text(body);
  if (!json.is_object()) throw Error("The list of pictures", "is not a JSON object", "an object with the list `names`");
  const JsonFields fields(json, {}, {});
  const std::vector<std::string> names = fields.texts_or_none("names");
  if (names.size() < 2 || names.size() > kMaxPictures)
    throw Error(
        "The dropped pictures",
        names.size() < 2 ? "are fewer than 2, so they show no depth" : fmt::format("{} pictures are too many", names.size()),
        fmt::format("2 to {} pictures of one scene, from left to right", kMaxPictures));
  for (const std::string& name : names)
    if (!is_picture_name(name))
      throw Error(printable(name), "is not a picture that can be read", ".jpg, .png, .tif, .webp, .exr or another picture");
  auto received = std::make_shared<Received>();
  received->title = fields.text_or("title", "Pictures");
  const std::vector<std::size_t> ranks = ranks_of(names);
  for (std::size_t i = 0; i < names.size(); ++i)
    received->files.push_back(received->folder.path() / fmt::format("{:06}{}", ranks[i], lower_ending(names[i])));
  received->names = names;
  received->sizes.assign(names.size(), 0);
  received_ = std::move(received);
}

void DroppedPictures::append(std::string_view path, const std::string& bytes) {
  Received& received = *received_;
  const std::size_t slash = std::min(path.find('/'), path.size());
  const auto index = whole_number<std::size_t>(path.substr(0, slash));
  const auto at = whole_number<std::uintmax_t>(path.substr(std::min(slash + 1, path.size())));
  if (!index || !at || *index >= received.files.size()) throw Error("The dropped pictures", "there is no such picture");
  std::uintmax_t& size = received.sizes[*index];
  if (*at + bytes.size() == size) return;  // a chunk that was sent again because its answer was lost
  if (*at != size)
    throw Error(printable(received.names[*index]), "a part of this file was not received", "dropping the pictures again");
  size += bytes.size();
  received.bytes += bytes.size();
  if (received.bytes > most_bytes_) {
    received_.reset();
    throw Error("drop", fmt::format("the pictures have more than {:.0f} MB", static_cast<double>(most_bytes_) / kMiB),
                "fewer or smaller ones; `lippmann view FOLDER` has no such limit");
  }
  std::ofstream file(received.files[*index], std::ios::binary | std::ios::app);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return;
  const std::string folder = received.folder.path().parent_path().string();
  received_.reset();
  throw Error(folder, "cannot be written: is the disk full?");
}

void DroppedPictures::show() {
  const std::shared_ptr<Received> received = std::exchange(received_, nullptr);
  try {
    auto field = std::make_unique<PageField>(received->folder.path(), LightFieldHints{.from = "views"}, context_);
    field->set_title(printable(received->title));
    const auto shown = std::make_shared<Shown>(received, std::move(field));
    const std::lock_guard lock(mutex_);
    shown_ = {shown, &shown->answers};
  } catch (const Error& error) {
    throw Error(received->with_page_names(error.where()), received->with_page_names(error.problem()),
                received->with_page_names(error.accepted()));
  }
}

std::shared_ptr<PageAnswers> DroppedPictures::shown() const {
  const std::lock_guard lock(mutex_);
  return shown_;
}

}  // namespace lippmann
