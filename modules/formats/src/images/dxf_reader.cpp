#include "images/dxf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"

namespace aisle {
namespace {

constexpr int kDepthMax = 8;  ///< of blocks in blocks
constexpr std::size_t kLinesMax = 1'000'000;
constexpr std::size_t kEntitiesMax = 1'000'000;  ///< blocks of blocks multiply
constexpr double kChord_rad = 5 * kDegree;
constexpr double kQuarterSlack_rad = 3 * kDegree;

/// A code and its value: the pairs of lines that a DXF consists of.
struct Group {
  int code = 0;
  std::string_view value;
};

/// The number that stands there; `otherwise` if none does, or one that no drawing has.
double dxf_number(std::string_view text, double otherwise = 0) {
  const auto value = parse_number(text);
  return value && std::abs(*value) <= kAnyNumber ? *value : otherwise;
}

/// One entity: its kind and its groups.
struct Entity {
  std::string_view kind;
  std::vector<Group> groups;

  std::string_view text(int code) const {
    for (const Group& group : groups) {
      if (group.code == code) return group.value;
    }
    return {};
  }
  double number(int code, double otherwise = 0) const { return dxf_number(text(code), otherwise); }
  Vec2 point(int code) const { return {number(code), number(code + 10)}; }
};

/// Where the entities of a block or of the drawing stand.
struct Placement {
  Mat2 turn = Mat2::Identity();
  Vec2 shift = Vec2::Zero();
  Vec2 operator*(const Vec2& p) const { return turn * p + shift; }
  Placement mirrored() const { return {turn * Vec2(-1, 1).asDiagonal(), shift}; }
};

class DxfReader {
 public:
  DxfReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  Result<DxfDrawing> read() {
    if (rest_.starts_with("AutoCAD Binary DXF"))
      return Problem{{name_}, "is a binary DXF; only the text form is read"};
    read_groups();
    if (failure_) return *failure_;
    for (const Entity& entity : entities_) draw(entity, {}, 0);
    if (drawing_.lines.size() >= kLinesMax || drawn_ >= kEntitiesMax)
      return Problem{{name_}, fmt::format("has more than {} lines or {} parts", kLinesMax, kEntitiesMax)};
    return drawing_;
  }

 private:
  void read_groups();
  void begin(std::string_view kind);
  void read_block_head(const Group& group);
  void draw(const Entity& entity, const Placement& outer, int depth);
  void draw_arc(const Placement& placed, const Vec2& centre, double radius, double from_rad,
                double sweep_rad);
  void draw_polyline(const Entity& entity, const Placement& placed);
  void draw_block(const Entity& insert, const Placement& placed, int depth);
  void line(const Placement& placed, const Vec2& start, const Vec2& end) {
    if (drawing_.lines.size() < kLinesMax) drawing_.lines.push_back({placed * start, placed * end});
  }

  std::string_view rest_;
  std::string name_;
  long line_ = 0;
  std::optional<Problem> failure_;
  std::string_view section_;
  std::string_view block_;  ///< whose entities are being read; empty: none
  Entity* open_ = nullptr;
  bool in_polyline_ = false;
  Entity other_;  ///< tables and the like, whose groups are passed over
  std::vector<Entity> entities_;
  std::map<std::string, std::vector<Entity>, std::less<>> blocks_;
  std::map<std::string, Vec2, std::less<>> block_base_;
  DxfDrawing drawing_;
  std::size_t drawn_ = 0;
};

std::optional<double> unit_of_insunits(std::string_view code) {
  static const std::map<std::string_view, double> units_m = {{"1", 0.0254}, {"2", 0.3048}, {"4", 0.001},
                                                             {"5", 0.01},   {"6", 1},      {"14", 0.1}};
  const auto unit = units_m.find(code);
  return unit == units_m.end() ? std::nullopt : std::optional(unit->second);
}

void DxfReader::begin(std::string_view kind) {
  open_ = &other_;
  other_ = {kind, {}};
  if (section_ != "ENTITIES" && section_ != "BLOCKS") return;
  if (kind == "BLOCK" || kind == "ENDBLK" || kind == "SEQEND") {
    in_polyline_ = false;
    if (kind != "SEQEND") block_ = {};
    return;
  }
  if (section_ == "BLOCKS" && block_.empty()) return;
  std::vector<Entity>& list = section_ == "ENTITIES" ? entities_ : blocks_[std::string(block_)];
  if (kind == "VERTEX" && in_polyline_) {
    open_ = &list.back();
    open_->groups.push_back({0, kind});
    return;
  }
  in_polyline_ = kind == "POLYLINE";
  list.push_back({kind, {}});
  open_ = &list.back();
}

void DxfReader::read_block_head(const Group& group) {
  if (group.code == 2) {
    block_ = group.value;
    block_base_[std::string(block_)] = Vec2::Zero();
  }
  if (block_.empty()) return;
  Vec2& base = block_base_[std::string(block_)];
  if (group.code == 10) base.x() = dxf_number(group.value);
  if (group.code == 20) base.y() = dxf_number(group.value);
}

void DxfReader::read_groups() {
  bool names_section = false, is_insunits = false;
  open_ = &other_;
  while (!rest_.empty()) {
    const std::string_view code_text = trimmed(take_line(rest_));
    const std::string_view value = trimmed(take_line(rest_));
    line_ += 2;
    const auto code = parse_number(code_text);
    if (!code || !(std::abs(*code) <= 10000)) {
      if (code_text.empty() && rest_.empty()) return;
      failure_ = Problem{{name_, line_ - 1}, fmt::format("'{}' is not a group code", printable(code_text))};
      return;
    }
    const Group group{static_cast<int>(*code), value};
    if (group.code == 0) {
      if (value == "EOF") return;
      names_section = value == "SECTION";
      if (value == "ENDSEC") section_ = {};
      begin(value);
    } else if (names_section && group.code == 2) {
      section_ = value;
      names_section = false;
    } else if (group.code == 9) {
      is_insunits = value == "$INSUNITS";
    } else if (is_insunits && group.code == 70) {
      drawing_.unit_m = unit_of_insunits(value);
      is_insunits = false;
    } else {
      if (other_.kind == "BLOCK" && open_ == &other_) read_block_head(group);
      open_->groups.push_back(group);
    }
  }
}

void DxfReader::draw(const Entity& entity, const Placement& outer, int depth) {
  ++drawn_;
  if (entity.number(67) == 1) return;  // on a sheet of paper, not in the building
  const bool is_seen_from_below = entity.kind != "LINE" && entity.number(230, 1) < 0;
  const Placement placed = is_seen_from_below ? outer.mirrored() : outer;
  if (entity.kind == "LINE") {
    line(placed, entity.point(10), entity.point(11));
  } else if (entity.kind == "LWPOLYLINE" || entity.kind == "POLYLINE") {
    draw_polyline(entity, placed);
  } else if (entity.kind == "ARC") {
    const double from_rad = entity.number(50) * kDegree;
    double sweep_rad = std::fmod(entity.number(51) * kDegree - from_rad, 2 * kPi);
    if (sweep_rad <= 0) sweep_rad += 2 * kPi;
    if (std::abs(sweep_rad - kPi / 2) < kQuarterSlack_rad) {
      ++drawing_.door_arcs;
    } else {
      draw_arc(placed, entity.point(10), entity.number(40), from_rad, sweep_rad);
    }
  } else if (entity.kind == "CIRCLE") {
    draw_arc(placed, entity.point(10), entity.number(40), 0, 2 * kPi);
  } else if (entity.kind == "INSERT") {
    draw_block(entity, placed, depth);
  } else {
    ++drawing_.skipped[printable(entity.kind)];
  }
}

void DxfReader::draw_arc(const Placement& placed, const Vec2& centre, double radius, double from_rad,
                         double sweep_rad) {
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(sweep_rad) / kChord_rad)));
  for (int i = 0; i < chords; ++i) {
    line(placed, centre + radius * unit(from_rad + sweep_rad * i / chords),
         centre + radius * unit(from_rad + sweep_rad * (i + 1) / chords));
  }
}

/// A bulge is the tangent of a quarter of the arc's angle, positive to the right of the chord.
void DxfReader::draw_polyline(const Entity& entity, const Placement& placed) {
  struct Corner {
    Vec2 p = Vec2::Zero();
    double bulge = 0;
  };
  std::vector<Corner> corners;
  bool is_corner = entity.kind == "LWPOLYLINE";  // a POLYLINE has its corners in VERTEX entities
  for (const Group& group : entity.groups) {
    is_corner = is_corner || group.code == 0;
    if (!is_corner) continue;
    const double value = dxf_number(group.value);
    if (group.code == 10) corners.push_back({{value, 0}});
    if (group.code == 20 && !corners.empty()) corners.back().p.y() = value;
    if (group.code == 42 && !corners.empty()) corners.back().bulge = value;
  }
  const bool is_closed = std::fmod(entity.number(70), 2) == 1;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < corners.size(); ++i) {
    const Vec2 start = corners[i].p, end = corners[(i + 1) % corners.size()].p;
    const double bulge = corners[i].bulge;
    if (std::abs(bulge) < 1e-6) {
      line(placed, start, end);
      continue;
    }
    const Vec2 centre = (start + end) / 2 + (1 - bulge * bulge) / (4 * bulge) * left_normal(end - start);
    const Vec2 from = start - centre;
    draw_arc(placed, centre, from.norm(), std::atan2(from.y(), from.x()), 4 * std::atan(bulge));
  }
}

void DxfReader::draw_block(const Entity& insert, const Placement& placed, int depth) {
  const auto block = blocks_.find(insert.text(2));
  const bool is_array = insert.number(70) > 1 || insert.number(71) > 1;
  if (block == blocks_.end() || depth >= kDepthMax || is_array) {
    ++drawing_.skipped["INSERT"];
    return;
  }
  const double turn_rad = insert.number(50) * kDegree;
  Mat2 turn;
  turn << std::cos(turn_rad), -std::sin(turn_rad), std::sin(turn_rad), std::cos(turn_rad);
  turn = turn * Vec2(insert.number(41, 1), insert.number(42, 1)).asDiagonal();
  const auto base = block_base_.find(insert.text(2));
  const Vec2 origin = base == block_base_.end() ? Vec2(0, 0) : base->second;
  const Placement inner{placed.turn * turn, placed * (insert.point(10) - turn * origin)};
  for (const Entity& entity : block->second) {
    if (drawing_.lines.size() >= kLinesMax || drawn_ >= kEntitiesMax) return;
    draw(entity, inner, depth + 1);
  }
}

}  // namespace

Result<DxfDrawing> parse_dxf(std::string_view bytes, const std::string& name) {
  return DxfReader(bytes, name).read();
}

}  // namespace aisle
