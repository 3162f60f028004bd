#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/core/ocl.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/features2d.hpp>
#include <vector>

#include "align/align_module.hpp"

namespace lippmann {
namespace {

static_assert(sizeof(std::array<float, 128>) == 128 * sizeof(float));

cv::Mat matrix_of(const GreyPicture& picture) {
  return {picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.codes.data())};
}

cv::Mat matrix_of(const Features& features) {
  return {static_cast<int>(features.descriptors.size()), 128, CV_32FC1,
          const_cast<float*>(features.descriptors.front().data())};
}

std::vector<int> nearest_features(const Features& from, const Features& to) {
  // Largest ratio of the distances to the nearest and to the second nearest feature; Lowe, section 7.1.
  constexpr float kMaxRatio = 0.8f;
  std::vector<std::vector<cv::DMatch>> found;
  cv::BFMatcher(cv::NORM_L2).knnMatch(matrix_of(from), matrix_of(to), found, 2);
  std::vector<int> nearest(found.size(), -1);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].size() == 2 && found[i][0].distance < kMaxRatio * found[i][1].distance) nearest[i] = found[i][0].trainIdx;
  return nearest;
}

class OpenCvModule : public AlignModule {
 public:
  OpenCvModule() {
    cv::setNumThreads(1);
    cv::ocl::setUseOpenCL(false);
  }

  Features features(const GreyPicture& picture, int most) const override {
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptors;
    cv::SIFT::create(most)->detectAndCompute(matrix_of(picture), cv::noArray(), points, descriptors);
    Features result;
    result.descriptors.resize(points.size());
    if (!points.empty())
      std::memcpy(result.descriptors.data(), descriptors.ptr(), points.size() * sizeof(result.descriptors[0]));
    for (const cv::KeyPoint& point : points) result.places.emplace_back(point.pt.x + 0.5f, point.pt.y + 0.5f);
    return result;
  }

  std::vector<FeatureMatch> matches(const Features& first, const Features& second) const override {
    std::vector<FeatureMatch> result;
    if (first.descriptors.size() < 2 || second.descriptors.size() < 2) return result;
    const std::vector<int> there = nearest_features(first, second), back = nearest_features(second, first);
    for (std::size_t i = 0; i < there.size(); ++i)
      if (there[i] >= 0 && back[static_cast<std::size_t>(there[i])] == static_cast<int>(i))
        result.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(there[i])});
    return result;
  }

  Image disparity(const GreyPicture& first, const GreyPicture& second, int least, int most) const override {
    constexpr int kBlock = 5, kSubPixels = 16;
    const int count = (most - least + 16) / 16 * 16;
    // OpenCV computes no disparity for pixels whose search range leaves the other image, so both images are extended by their
    // edge pixels.
    const int border = std::max(std::abs(least), std::abs(least + count)) + kBlock;
    cv::Mat wide_first, wide_second, found;
    cv::copyMakeBorder(matrix_of(first), wide_first, 0, 0, border, border, cv::BORDER_REPLICATE);
    cv::copyMakeBorder(matrix_of(second), wide_second, 0, 0, border, border, cv::BORDER_REPLICATE);
    constexpr int kSmallStep = 8 * kBlock * kBlock,
                  kLargeStep = 32 * kBlock * kBlock;  // smoothness penalties that OpenCV's documentation recommends
    cv::StereoSGBM::create(least, count, kBlock, kSmallStep, kLargeStep, -1, 31, 5, 100, 2)
        ->compute(wide_first, wide_second, found);
    Image result(first.width, first.height, 1);
    for (int y = 0; y < first.height; ++y)
      for (int x = 0; x < first.width; ++x) {
        const int code = found.at<short>(y, x + border);
        result.pixel(x, y)[0] =
            code < kSubPixels * least ? -std::numeric_limits<float>::infinity() : static_cast<float>(code) / kSubPixels;
      }
    return result;
  }
};

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_align_module(int version) {
  static const lippmann::OpenCvModule module;
  return version == lippmann::kAlignModuleVersion ? static_cast<const lippmann::AlignModule*>(&module) : nullptr;
}
