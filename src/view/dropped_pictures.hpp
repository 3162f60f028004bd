// Receives images that are dropped on a page, in chunks, and shows them as the views of a light field. Thread-safe.
//
// The names that the page sends determine the order of the views; the stored files have other names. The images shown and those
// being received have a temporary folder each, which is removed when newer images replace them.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "lippmann/core/context.hpp"
#include "view/answers.hpp"

namespace lippmann {

class DroppedPictures {
 public:
  static constexpr std::size_t kMaxPictures = 1000;
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 30;

  explicit DroppedPictures(const Context& context, std::uintmax_t most_bytes = kMostBytes);
  ~DroppedPictures();

  /// Handles a POST below "drop/":
  ///   begin  {"title", "names"}  starts a new set and discards images received but not shown
  ///   N/AT   appends the body to the image with index N in `names`, which must have AT bytes; a repeated chunk is ignored
  ///   show   shows the images as views from left to right, in the natural order of their names
  /// Throws Error.
  void post(std::string_view path, const std::string& body);

  /// Answers requests for the images shown; null before any are shown.
  std::shared_ptr<PageAnswers> shown() const;

 private:
  struct Received;
  struct Shown;
  void begin(const std::string& body);
  void append(std::string_view path, const std::string& bytes);
  void show();

  const Context& context_;
  const std::uintmax_t most_bytes_;
  std::mutex receiving_;
  std::shared_ptr<Received> received_;
  mutable std::mutex mutex_;  ///< guards the members below
  std::shared_ptr<PageAnswers> shown_;
};

}  // namespace lippmann
