#include "aisle/guidance/sections/guided_path.hpp"

#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kCornerMin = 0.9;     // sine of the angle between the base lines of a corner, at least
constexpr double kBeyondMin_m = 0.12;  // from the vehicle's turn to the wall ahead, at least

void append(GuidedPath& guided, std::vector<PathPiece>& pieces, const PathPiece& piece,
            const SectionGuide& guide) {
  pieces.push_back(piece);
  guided.guides.push_back(guide);
}

/// How far beyond its end a piece meets a line beside another piece; negative: before its end.
double meeting_m(const PathPiece& piece, const PathPiece& other, double lateral_m) {
  const Pose2 T_end_other = between(piece.end(), other.T_map_start);
  const Vec2 along = unit(T_end_other.theta);
  const Vec2 p_end_line = T_end_other.position() + lateral_m * left_normal(along);
  return cross(p_end_line, along) / along.y();
}

/// Adds to a section's guide what the next section's base lines mean for it.
void add_corner(SectionGuide& guide, const PathPiece& piece, const SectionGuide& next,
                const PathPiece& next_piece) {
  const double turn = std::sin(next_piece.T_map_start.theta - piece.T_map_start.theta);
  if (std::abs(turn) < kCornerMin) return;
  guide.turns_right = turn < 0;
  const auto outer_m = guide.turns_right ? next.left_m : next.right_m,
             inner_m = guide.turns_right ? next.right_m : next.left_m;
  const double outwards = guide.turns_right ? 1 : -1;
  if (outer_m && !guide.ahead_m) {
    const double ahead_m = meeting_m(piece, next_piece, outwards * *outer_m);
    if (ahead_m > kBeyondMin_m) guide.ahead_m = ahead_m;
  }
  if (inner_m) guide.line_ends_m = -meeting_m(piece, next_piece, -outwards * *inner_m);
}

/// @param is_straight  whether a piece is a straight section
template <class IsStraight>
void add_corners(GuidedPath& guided, IsStraight is_straight) {
  const auto& pieces = guided.path.pieces();
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!is_straight(i)) continue;
    std::size_t next = i + 1;
    while (next < pieces.size() && !is_straight(next)) ++next;
    if (next < pieces.size() && guided.guides[next].follows)
      add_corner(guided.guides[i], pieces[i], guided.guides[next], pieces[next]);
  }
}

}  // namespace

GuidedPath guided_path(const SectionList& sections, const Pose2& T_map_start, SectionRun run) {
  std::vector<std::size_t> piece_sections;
  const Path there = path_of(sections, T_map_start, &piece_sections);
  const auto guide_of = [&](std::size_t piece) {
    const Section& section = sections[piece_sections[piece]];
    const bool follows = section.kind == Section::Kind::kFollow || section.kind == Section::Kind::kHybrid;
    return SectionGuide{.section = piece_sections[piece],
                        .follows = follows,
                        .right_m = section.right_m,
                        .left_m = section.left_m,
                        .ahead_m = section.ahead_m};
  };
  GuidedPath guided{.path = {}, .guides = {}, .comes_home = run == SectionRun::kThereAndBack};
  std::vector<PathPiece> pieces;
  if (run != SectionRun::kBack) {
    for (std::size_t i = 0; i < piece_sections.size(); ++i)
      append(guided, pieces, there.pieces()[i], guide_of(i));
  }
  const auto turn_about = [&](std::size_t section) {
    append(guided, pieces, {pieces.back().end(), {0, kPi}}, {.section = section});
  };
  if (guided.comes_home) turn_about(sections.size() - 1);
  if (run != SectionRun::kThere) {
    const Path back = there.reversed();
    for (std::size_t i = 0; i < back.pieces().size(); ++i) {
      SectionGuide guide = guide_of(back.pieces().size() - 1 - i);
      std::swap(guide.right_m, guide.left_m);
      guide.ahead_m.reset();
      append(guided, pieces, back.pieces()[i], guide);
    }
  }
  if (guided.comes_home) turn_about(0);
  guided.path = Path(std::move(pieces));
  add_corners(guided, [&](std::size_t i) {
    return sections[guided.guides[i].section].is_straight() && !guided.path.pieces()[i].is_on_the_spot();
  });
  return guided;
}

}  // namespace aisle
