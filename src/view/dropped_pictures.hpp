// Pictures that were dropped on a page: received in pieces, kept in a temporary folder, and shown as the views of a light
// field.
//
// Names from the page decide the order of the views and stand in messages; files have names of this program's own. The folder
// of what is shown and that of what is being received are removed when they are replaced, and when this object goes.
// Thread-safe.
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
  static constexpr std::size_t kMostPictures = 1000;
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 30;  ///< of all pictures together

  /// `context` must outlive this object. most_bytes: of all pictures together.
  explicit DroppedPictures(const Context& context, std::uintmax_t most_bytes = kMostBytes);
  ~DroppedPictures();

  /// Below "drop/":
  ///   begin  {"title", "names"}  forgets what was received but not shown
  ///   N/AT   bytes of the picture of that index in `names`, from that byte on: the next ones, or the last ones once more
  ///   show   shows them from left to right, in the natural order of their names
  /// Throws Error.
  void post(std::string_view path, const std::string& body);

  /// What is shown; null: nothing was dropped yet.
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
  mutable std::mutex mutex_;  ///< of what follows
  std::shared_ptr<PageAnswers> shown_;
};

}  // namespace lippmann
