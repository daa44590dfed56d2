#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "aisle/vision/check/image_evidence.hpp"

namespace aisle {
namespace {

constexpr int kQualityWidth_px = 640;
constexpr int kDarkMax = 5, kBrightMin = 250;
constexpr int kBlurReach_px = 4;  // Crete's kernel: the mean of nine pixels

/// How much of the steps along lines of pixels survives one more blur.
class BlurSum {
 public:
  /// @param stride  bytes from one pixel of the line to the next
  void add_line(const std::uint8_t* pixels, int count, std::size_t stride) {
    constexpr int kWindow = 2 * kBlurReach_px + 1;
    if (count <= kWindow) return;
    const auto at = [&](int i) { return static_cast<int>(pixels[static_cast<std::size_t>(i) * stride]); };
    int sum = 0;
    for (int i = 0; i < kWindow; ++i) sum += at(i);
    for (int i = kBlurReach_px + 1; i + kBlurReach_px < count; ++i) {
      const int before = sum;
      sum += at(i + kBlurReach_px) - at(i - kBlurReach_px - 1);
      const int step = std::abs(at(i) - at(i - 1)) * kWindow;
      steps_ += step;
      lost_ += std::max(0, step - std::abs(sum - before));
    }
  }
  double blur() const {
    return steps_ > 0 ? static_cast<double>(steps_ - lost_) / static_cast<double>(steps_) : 0;
  }

 private:
  long long steps_ = 0, lost_ = 0;
};

/// The grey level beneath which this share of the pixels is.
int level_at(const std::array<long long, 256>& counts, long long pixels, double share) {
  long long sum = 0;
  for (int level = 0; level < 256; ++level) {
    sum += counts[static_cast<std::size_t>(level)];
    if (static_cast<double>(sum) > share * static_cast<double>(pixels)) return level;
  }
  return 255;
}

}  // namespace

ImageQuality image_quality(const Image& grey) {
  const Image looked_at =
      grey.width_px > kQualityWidth_px
          ? shrunk(grey, kQualityWidth_px,
                   std::max(1, static_cast<int>(std::lround(static_cast<double>(grey.height_px) *
                                                            kQualityWidth_px / grey.width_px))))
          : grey;
  std::array<long long, 256> counts{};
  for (const std::uint8_t level : looked_at.bytes) ++counts[level];
  const auto pixels = static_cast<long long>(looked_at.bytes.size());
  ImageQuality quality;
  for (int level = 0; level < 256; ++level) {
    const double share =
        static_cast<double>(counts[static_cast<std::size_t>(level)]) / static_cast<double>(pixels);
    if (level <= kDarkMax) quality.dark_share += share;
    if (level >= kBrightMin) quality.bright_share += share;
  }
  quality.contrast = level_at(counts, pixels, 0.95) - level_at(counts, pixels, 0.05);
  BlurSum across, down;
  for (int v = 0; v < looked_at.height_px; ++v) across.add_line(looked_at.row(v), looked_at.width_px, 1);
  for (int u = 0; u < looked_at.width_px; ++u)
    down.add_line(looked_at.bytes.data() + u, looked_at.height_px, looked_at.row_bytes());
  quality.blur_across = across.blur();
  quality.blur_down = down.blur();
  return quality;
}

}  // namespace aisle
