#pragma once
/// How much is kept free around a vehicle's footprint, and what for; the least first. What a way keeps is
/// more than what is watched while it is driven, so a way that was found is one that the watch lets pass. All
/// of it gives way where the vehicle has less room already: then it must not become less still
/// (`kRoomNoise_m`).

namespace aisle {

/// On the vehicle's own trail, from what is struck now: it passed there before.
inline constexpr double kTrailMargin_m = 0.01;
/// Wherever the vehicle could come to stand, from what stands on the floor and what is struck now: as much as
/// both may be wrong.
inline constexpr double kWatchMargin_m = 0.02;
/// Where there is less than that, or on the trail, it must be enough so much farther on as well.
inline constexpr double kStopSlack_m = 0.03;
/// So far a vehicle that creeps strays from its way, and rolls on where it stops.
inline constexpr double kStray_m = 0.01;
/// The least that a way keeps, where the vehicle squeezes through. All others keep
/// `CarSearchParams::margin_m`, so that it need not creep.
inline constexpr double kSqueezeMargin_m = kWatchMargin_m + kStray_m;

}  // namespace aisle
