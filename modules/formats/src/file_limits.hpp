#pragma once
/// Limits on what a file may contain. A larger file is refused before memory is allocated for it.

#include <cstddef>

namespace aisle {

inline constexpr std::size_t kUnpackedFreely_bytes = 32 << 20;  ///< whatever they were packed to
inline constexpr std::size_t kUnpackedRatioMax = 200;           ///< of what is larger
inline constexpr std::size_t kSettingsBytesMax = 1 << 20;  ///< vehicles, scenarios, calibrations, floor marks
inline constexpr std::size_t kWorldBytesMax = 16 << 20;
inline constexpr std::size_t kJsonBytesMax = 16 << 20;
inline constexpr double kCoordinateMax_m = 10'000;
inline constexpr std::size_t kPlanBytesMax = std::size_t{512} << 20;  ///< of a floor plan's image
inline constexpr int kPlanSideMax = 8192;                             ///< cells or pixels
inline constexpr int kImageSideMax_px = 16384;
inline constexpr std::size_t kImagePixelsMax = std::size_t{1} << 25;  ///< a television's 7680 x 4320 fit
inline constexpr double kAnyNumber = 1e15;                            ///< where any finite number is valid

}  // namespace aisle
