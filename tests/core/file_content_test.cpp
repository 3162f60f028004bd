#include "core/file_content.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace lippmann {
namespace {

using namespace std::string_view_literals;

FileContent content_of(std::string_view text) { return describe_content(std::as_bytes(std::span(text))); }

TEST(FileContent, stand_ins_name_the_remedy) {
  const std::string_view pointer =
      "version https://git-lfs.github.com/spec/v1\noid "
      "sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\n"
      "size 12345\n";
  EXPECT_EQ(content_of(pointer).what, "a Git LFS pointer, which stands for a file of 12345 bytes");
  EXPECT_EQ(content_of(pointer).advice, "the file itself: run `git lfs pull` in its repository");
  EXPECT_EQ(content_of("").what, "empty (0 bytes)");
  EXPECT_EQ(content_of("\xef\xbb\xbf\r\n <!DOCTYPE HTML><html>").what, "a web page (HTML)");
  EXPECT_EQ(content_of("<HTML lang=en>").what, "a web page (HTML)");
  EXPECT_EQ(content_of("\0\0\0\0"sv).what, "nothing but zero bytes");
  EXPECT_EQ(content_of(" \n\n").what, "nothing but white space");
  for (const std::string_view text : {pointer, ""sv, "<html>"sv, "\0\0"sv, " "sv}) {
    EXPECT_FALSE(content_of(text).advice.empty());
    EXPECT_TRUE(stand_in_for_file(std::as_bytes(std::span(text))));
  }
}

TEST(FileContent, other_files_have_no_remedy) {
  EXPECT_EQ(content_of("\x89PNG\r\n\x1a\n rest").what, "a PNG picture");
  EXPECT_EQ(content_of("glTF\2\0\0\0"sv).what, "a binary glTF scene (.glb)");
  EXPECT_EQ(content_of("P3\n2 2").what, "a netpbm picture (P3)");
  EXPECT_EQ(content_of("PK\x03\x04").what, "a ZIP archive");
  EXPECT_EQ(content_of("RIFF....WEBP").what, "a WebP picture");
  EXPECT_EQ(content_of("<?xml version=\"1.0\"?>").what, "an XML document");
  EXPECT_EQ(content_of("404: Not Found\nmore").what, "text that begins '404: Not Found'");
  EXPECT_EQ(content_of("\x01\x02 noise").what, "binary data of an unknown kind");
  EXPECT_EQ(content_of("a").what, "text that begins 'a'");
  for (const std::string_view text : {"\x89PNG\r\n\x1a\n"sv, "hello"sv, "\x01"sv, "{\"asset\":{}}"sv, "# obj"sv})
    EXPECT_FALSE(stand_in_for_file(std::as_bytes(std::span(text))));
}

}  // namespace
}  // namespace lippmann
