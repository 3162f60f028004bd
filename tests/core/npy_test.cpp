#include "core/npy.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>

#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using test::error_message;
using testing::HasSubstr;

const std::vector<float> kSixNumbers{1, 2, 3, 4, 5, 6};

std::vector<std::byte> npy_with(const std::string& header, std::span<const std::byte> data) {
  std::string head("\x93NUMPY\x01\0", 8);
  head += static_cast<char>(header.size()), head += '\0', head += header;
  const auto bytes = std::as_bytes(std::span(head));
  std::vector<std::byte> file(bytes.begin(), bytes.end());
  file.insert(file.end(), data.begin(), data.end());
  return file;
}

std::string npy_refusal(const std::string& header) {
  return error_message([&] { parse_npy(npy_with(header, std::as_bytes(std::span(kSixNumbers))), "a.npy"); });
}

TEST(Npy, fortran_order_is_read) {
  const NpyArray columns = parse_npy(
      npy_with("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3), }", std::as_bytes(std::span(kSixNumbers))), "a");
  EXPECT_EQ(columns.shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(columns.values, (std::vector<double>{1, 3, 5, 2, 4, 6}));
}

TEST(Npy, big_endian_numbers_are_read) {
  const std::byte two[] = {std::byte{0x40}, std::byte{0}, std::byte{0}, std::byte{0}};
  EXPECT_EQ(parse_npy(npy_with("{'descr': '>f4', 'fortran_order': False, 'shape': (1,), }", two), "a").values[0], 2.0);
}

TEST(Npy, other_sizes_and_types_are_refused) {
  EXPECT_THAT(npy_refusal("{'descr': '<f4', 'fortran_order': False, 'shape': (7,), }"), HasSubstr("a.npy: has 24 bytes"));
  EXPECT_THAT(npy_refusal("{'descr': '<i8', 'fortran_order': False, 'shape': (3,), }"), HasSubstr("<i8"));
  EXPECT_THAT(npy_refusal("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2, 3), }"), HasSubstr("3 dimensions"));
  EXPECT_THAT(npy_refusal("{'descr': '<f4', 'fortran_order': False, 'shape': (4294967296, 4294967296), }"),
              HasSubstr("fewer numbers"));
  EXPECT_THAT(error_message([] { parse_npy({}, "a.npy"); }), HasSubstr("not a .npy file"));
}

TEST(Npy, written_arrays_are_read_again) {
  const std::vector<std::byte> file = encode_npy(std::span<const float>(kSixNumbers), {2, 3});
  const NpyArray again = parse_npy(file, "a");
  EXPECT_EQ(again.shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(std::ranges::equal(again.values, kSixNumbers));
  // NumPy can map a file into memory if its data begin at a multiple of 64 bytes. Here, the data are the last 24 bytes.
  EXPECT_EQ((file.size() - 24) % 64, 0U);
}

TEST(Npy, types_have_the_names_of_numpy) {
  const auto header_of = []<class T>(T value) {
    const std::vector<std::byte> file = encode_npy(std::span<const T>(&value, 1), {1});
    return std::string(reinterpret_cast<const char*>(file.data()), file.size());
  };
  EXPECT_THAT(header_of(std::uint8_t{1}), HasSubstr("'|u1'"));
  EXPECT_THAT(header_of(std::int16_t{1}), HasSubstr("'<i2'"));
  EXPECT_THAT(header_of(1.0), HasSubstr("'<f8'"));
}

}  // namespace
}  // namespace lippmann
