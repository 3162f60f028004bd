// Memory streams for reading and writing OpenEXR files.
#pragma once

#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfThreading.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <vector>

namespace lippmann {

class ExrInput : public Imf::IStream {
 public:
  explicit ExrInput(std::span<const std::byte> file) : IStream("memory"), file_(file) {}

  bool read(char to[], int count) override {
    const auto wanted = static_cast<std::uint64_t>(count);
    if (count < 0 || at_ > file_.size() || wanted > file_.size() - at_) throw std::runtime_error("the file is truncated");
    std::memcpy(to, file_.data() + at_, wanted);
    at_ += wanted;
    return at_ < file_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = at; }

 private:
  std::span<const std::byte> file_;
  std::uint64_t at_ = 0;
};

class ExrOutput : public Imf::OStream {
 public:
  ExrOutput() : OStream("memory") {}

  void write(const char from[], int count) override {
    const auto bytes = std::as_bytes(std::span(from, static_cast<std::size_t>(count)));
    if (file.size() < at_ + bytes.size()) file.resize(at_ + bytes.size());
    std::memcpy(file.data() + at_, bytes.data(), bytes.size());
    at_ += bytes.size();
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t at) override { at_ = at; }

  std::vector<std::byte> file;

 private:
  std::uint64_t at_ = 0;
};

}  // namespace lippmann
