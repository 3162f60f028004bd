#include <gmock/gmock.h>
#include <hdf5.h>

#include <filesystem>
#include <fstream>

#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;

/// Writes arrays of bytes or floats, and attributes of the root group.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const fs::path& path) : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  Hdf5Writer(const Hdf5Writer&) = delete;
  ~Hdf5Writer() { H5Fclose(file_); }

  template <class T>
  void add(const char* name, const std::vector<hsize_t>& shape, const std::vector<T>& values) const {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t type = sizeof(T) == 1 ? H5T_STD_U8LE : sizeof(T) == 2 ? H5T_STD_U16BE : H5T_IEEE_F32LE;
    const hid_t memory = sizeof(T) == 1 ? H5T_NATIVE_UINT8 : sizeof(T) == 2 ? H5T_NATIVE_UINT16 : H5T_NATIVE_FLOAT;
    const hid_t array = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(array, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(array), H5Sclose(space);
  }

  /// The HCI archive stores attributes as arrays of one value.
  void attribute(const char* name, double value) const {
    const hsize_t one = 1;
    const hid_t space = H5Screate_simple(1, &one, nullptr);
    const hid_t attribute = H5Acreate2(file_, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(attribute), H5Sclose(space);
  }

  void cameras() const {
    attribute("dH", 0.02), attribute("dV", 0.02), attribute("focalLength", 700.0), attribute("shift", 2.0);
  }

  hid_t file() const { return file_; }

 private:
  hid_t file_;
};

constexpr int kRows = 2, kColumns = 3, kHeight = 4, kWidth = 5;

/// Returns codes that depend on the position, times `factor`: red is 10 t + s for the view in row t and column s, green
/// the row and blue the column of the pixel.
template <class T>
std::vector<T> codes_by_place(int factor) {
  std::vector<T> codes;
  for (int t = 0; t < kRows; ++t)
    for (int s = 0; s < kColumns; ++s)
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
          for (const int code : {10 * t + s, y, x}) codes.push_back(static_cast<T>(factor * code));
  return codes;
}

const std::vector<hsize_t> kShape{kRows, kColumns, kHeight, kWidth, 3}, kDepthShape{kRows, kColumns, kHeight, kWidth};

LightField read_h5(const fs::path& path) { return find_format("hci-hdf5", "from").read(path, {}); }

std::string refusal_of(const fs::path& path) {
  return error_message([&] { read_h5(path); });
}

TEST(HciHdf5, views_count_from_the_top_right) {
  const TempDir dir;
  const fs::path path = dir / "lf.h5";
  {
    const Hdf5Writer file(path);
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.cameras();
  }
  const LightField field = read_h5(path);
  EXPECT_EQ(field.grid, (ViewGrid{kColumns, kRows}));
  EXPECT_EQ(field.view_size, Vec2i(kWidth, kHeight));
  // View 0 is the lower left view, stored at t = 1, s = 2.
  for (const auto& [view, red] : {std::pair(0, 12), std::pair(2, 10), std::pair(3, 2), std::pair(5, 0)}) {
    const Image8 codes = std::get<Image8>(view_of(field, view));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const unsigned char* pixel = &codes.rgb[3 * static_cast<std::size_t>(y * kWidth + x)];
        EXPECT_EQ((std::array<int, 3>{pixel[0], pixel[1], pixel[2]}), (std::array<int, 3>{red, y, x})) << view;
      }
  }
  EXPECT_FALSE(field.depth);
  EXPECT_DOUBLE_EQ(field.cameras->distance_mm, 7000.0);
}

TEST(HciHdf5, depth_becomes_disparity_by_the_published_formula) {
  const TempDir dir;
  const fs::path path = dir / "lf.h5";
  std::vector<float> depth;
  for (int i = 0; i < kRows * kColumns * kHeight * kWidth; ++i) depth.push_back(3.0f + 0.25f * static_cast<float>(i));
  {
    const Hdf5Writer file(path);
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.add("GT_DEPTH", kDepthShape, depth);
    file.cameras();
  }
  const LightField field = read_h5(path);
  const ViewCameras& cameras = *field.cameras;
  const Image lowest_left = depth_of(field, 0);
  const std::size_t first = (1 * kColumns + 2) * kHeight * kWidth;
  for (std::size_t i = 0; i < lowest_left.data.size(); ++i) {
    // Off-axis views: if the eye moves by b, a point at z moves by b z / (distance - z) in the plane z = 0.
    const double z = lowest_left.data[i], step = 20.0 / cameras.pixel_mm.x;
    EXPECT_NEAR(step * z / (cameras.distance_mm - z), 0.02 * 700.0 / depth[first + i] - 2.0, 1e-5) << i;
  }
}

TEST(HciHdf5, sixteen_bits_and_grey_are_read) {
  const TempDir dir;
  {
    const Hdf5Writer file(dir / "words.h5");
    file.add("LF", kShape, codes_by_place<std::uint16_t>(1000));
    file.cameras();
  }
  EXPECT_EQ(std::get<Image16>(view_of(read_h5(dir / "words.h5"), 0)).rgb[0], 12000);
  {
    const Hdf5Writer file(dir / "grey.h5");
    file.add("LF", {1, 2, 1, 2, 1}, std::vector<unsigned char>{1, 2, 3, 4});
    file.cameras();
  }
  EXPECT_EQ(std::get<Image8>(read_h5(dir / "grey.h5").stack).rgb,
            (std::vector<unsigned char>{3, 3, 3, 4, 4, 4, 1, 1, 1, 2, 2, 2}));
}

TEST(HciHdf5, file_is_known_by_its_ending) {
  const TempDir dir;
  {
    const Hdf5Writer file(dir / "lf.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.cameras();
  }
  EXPECT_EQ(open_light_field(dir / "lf.h5", "", {}).field.grid.count(), kRows * kColumns);
}

TEST(HciHdf5, files_without_attributes_have_no_cameras) {
  const TempDir dir;
  {
    const Hdf5Writer file(dir / "lf.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
  }
  std::string warning;
  FormatOptions options;
  options.warn = [&](std::string_view text) { warning = text; };
  const LightField field = find_format("hci-hdf5", "from").read(dir / "lf.h5", options);
  EXPECT_FALSE(field.cameras || field.poses);
  EXPECT_THAT(warning, AllOf(HasSubstr("lf.h5"), HasSubstr("focalLength")));
}

TEST(HciHdf5, other_files_are_refused) {
  const TempDir dir;
  EXPECT_THAT(refusal_of(dir / "missing.h5"), HasSubstr("missing.h5"));
  std::ofstream(dir / "text.h5") << "no HDF5";
  EXPECT_THAT(refusal_of(dir / "text.h5"), AllOf(HasSubstr("text.h5"), HasSubstr("no HDF5 file")));
  { const Hdf5Writer file(dir / "empty.h5"); }
  EXPECT_THAT(refusal_of(dir / "empty.h5"), HasSubstr("no array LF"));
  {
    const Hdf5Writer file(dir / "flat.h5");
    file.add("LF", {2, 2}, std::vector<unsigned char>(4));
  }
  EXPECT_THAT(refusal_of(dir / "flat.h5"), HasSubstr("shape 2x2"));
  {
    const Hdf5Writer file(dir / "floats.h5");
    file.add("LF", {1, 1, 1, 1, 3}, std::vector<float>(3));
  }
  EXPECT_THAT(refusal_of(dir / "floats.h5"), HasSubstr("floats of 4 bytes"));
  {
    const Hdf5Writer file(dir / "depth.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.add("GT_DEPTH", {kHeight, kWidth}, std::vector<float>(kHeight * kWidth));
    file.cameras();
  }
  EXPECT_THAT(refusal_of(dir / "depth.h5"), AllOf(HasSubstr("GT_DEPTH has the shape 4x5"), HasSubstr("2x3x4x5")));
  {
    const Hdf5Writer file(dir / "codes.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.add("GT_DEPTH", kDepthShape, std::vector<std::uint16_t>(kRows * kColumns * kHeight * kWidth));
    file.cameras();
  }
  EXPECT_THAT(refusal_of(dir / "codes.h5"), HasSubstr("other numbers of 2 bytes"));
  EXPECT_THAT(error_message([&] { find_output_format("hci-hdf5", "to"); }), HasSubstr("can only be read; accepted: hci"));
}

TEST(HciHdf5, data_in_other_files_is_not_read) {
  const TempDir dir;
  {
    const Hdf5Writer file(dir / "lf.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
  }
  {
    const Hdf5Writer file(dir / "link.h5");
    H5Lcreate_external("lf.h5", "/LF", file.file(), "LF", H5P_DEFAULT, H5P_DEFAULT);
  }
  EXPECT_THAT(refusal_of(dir / "link.h5"), HasSubstr("no array LF"));
  {
    const Hdf5Writer file(dir / "external.h5");
    const std::vector<hsize_t> shape = kShape;
    const hid_t space = H5Screate_simple(5, shape.data(), nullptr), properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, "lf.h5", 0, kRows * kColumns * kHeight * kWidth * 3);
    H5Dclose(H5Dcreate2(file.file(), "LF", H5T_STD_U8LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties), H5Sclose(space);
  }
  EXPECT_THAT(refusal_of(dir / "external.h5"), HasSubstr("another file"));
}

TEST(HciHdf5, cut_files_are_refused) {
  const TempDir dir;
  {
    const Hdf5Writer file(dir / "lf.h5");
    file.add("LF", kShape, codes_by_place<unsigned char>(1));
    file.cameras();
  }
  const std::uintmax_t whole = fs::file_size(dir / "lf.h5");
  for (const std::uintmax_t share : {1, 2, 3}) {
    fs::copy_file(dir / "lf.h5", dir / "cut.h5", fs::copy_options::overwrite_existing);
    fs::resize_file(dir / "cut.h5", whole * share / 4);
    EXPECT_THAT(refusal_of(dir / "cut.h5"), HasSubstr("cut.h5")) << share;
  }
}

}  // namespace
}  // namespace lippmann
