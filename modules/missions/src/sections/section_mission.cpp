#include "aisle/missions/sections/section_mission.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace aisle {
namespace {

constexpr double kPictureWorthy_m = 0.5;  // shorter sections all look the same

/// Records the mission's session, and collects the mission's result.
class SectionMissionRecorder final : public MissionRecorder {
 public:
  SectionMissionRecorder(std::optional<SessionRecord>& session, const Vehicle& vehicle,
                         const TruthSource* truth, const SectionNavigator& navigator, bool keeps_images,
                         SectionMissionResult& result)
      : MissionRecorder(session, vehicle, truth),
        navigator_(navigator),
        keeps_images_(keeps_images),
        result_(result) {}

  Result<Observation> keep(Observation observation) override {
    auto kept = MissionRecorder::keep(std::move(observation));
    if (kept && keeps_images_ && !kept->images.empty()) last_image_ = kept->images.front().pixels;
    return kept;
  }

  Problems keep(const Decision& decision) override {
    result_.T_map_driven.push_back(navigator_.pose());
    show_pose({navigator_.pose()});
    if (is_watched()) show_overlay(overlay_of(navigator_.edges()));
    if (last_image_) keep_image();
    if (decision.state == "following") note_followed_edge();
    return MissionRecorder::keep(decision);
  }

 private:
  /// Keeps the first image after the middle of a straight section.
  void keep_image() {
    const PathPoint& point = navigator_.point();
    const PathPiece& piece = navigator_.path().pieces()[point.piece];
    const double middle_m = navigator_.path().start_m(point.piece) + piece.path_m() / 2;
    const bool is_worth_it = piece.arc.turn_rad == 0 && piece.path_m() > kPictureWorthy_m;
    if (!is_worth_it || point.along_m < middle_m || point.piece == pictured_piece_) return;
    pictured_piece_ = point.piece;
    result_.images.push_back({*last_image_, fmt::format("section {}", navigator_.guide().section + 1)});
  }

  void note_followed_edge() {
    const auto learned_m = navigator_.guide().right_m;
    if (!learned_m || T_world_vehicle() == nullptr) return;
    const PathPoint& point = navigator_.point();
    result_.followed.push_back({point.piece, point.T_map_path.theta, *learned_m, *T_world_vehicle()});
  }

  const SectionNavigator& navigator_;
  bool keeps_images_;
  SectionMissionResult& result_;
  std::shared_ptr<const Image> last_image_;
  std::optional<std::size_t> pictured_piece_;
};

}  // namespace

Result<SectionMissionResult> drive_section_mission(Vehicle& vehicle, const TruthSource* truth,
                                                   SectionNavigator& navigator, bool keeps_images,
                                                   std::optional<SessionRecord>& session,
                                                   Progress& progress) {
  SectionMissionResult result;
  SectionMissionRecorder record(session, vehicle, truth, navigator, keeps_images, result);
  if (Problems problems = drive_mission(vehicle, truth, navigator, record, progress, result);
      !problems.empty())
    return problems;
  return result;
}

}  // namespace aisle
