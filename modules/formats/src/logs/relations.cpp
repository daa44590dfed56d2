#include "aisle/formats/logs/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "aisle/formats/whole_file.hpp"
#include "field_reader.hpp"
#include "file_limits.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr double kSameStamp_s = 1e-3;

/// Scans by recorded stamp, in whatever order they were recorded.
class ScansByStamp {
 public:
  explicit ScansByStamp(const LaserLog& log) : scans_(log.scans), order_(log.scans.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::size_t a, std::size_t b) { return scans_[a].stamp_s < scans_[b].stamp_s; });
  }

  /// The scan with the nearest stamp; nullopt if it is more than a millisecond away.
  std::optional<std::size_t> find(double stamp_s) const {
    const auto not_before =
        std::lower_bound(order_.begin(), order_.end(), stamp_s,
                         [&](std::size_t scan, double s) { return scans_[scan].stamp_s < s; });
    std::optional<std::size_t> nearest;
    double nearest_s = kSameStamp_s;
    const auto consider = [&](std::size_t scan) {
      const double away_s = std::abs(scans_[scan].stamp_s - stamp_s);
      if (away_s > nearest_s) return;
      nearest = scan;
      nearest_s = away_s;
    };
    if (not_before != order_.begin()) consider(*std::prev(not_before));
    if (not_before != order_.end()) consider(*not_before);
    return nearest;
  }

 private:
  const std::vector<LaserScan>& scans_;
  std::vector<std::size_t> order_;
};

std::size_t count_fields(std::string_view line) {
  FieldReader fields(line);
  std::size_t count = 0;
  while (!fields.word().empty()) ++count;
  return count;
}

std::size_t read_stamped_scan(FieldReader& fields, const ScansByStamp& scans) {
  const double stamp_s = fields.number("stamp", kAnyNumber);
  if (!fields.ok()) return 0;
  const auto scan = scans.find(stamp_s);
  if (!scan) fields.fail(fmt::format("the log has no scan with the stamp {:.6f}", stamp_s));
  return scan.value_or(0);
}

std::size_t read_numbered_scan(FieldReader& fields, std::size_t scans) {
  const double number = fields.number("number of a scan", kAnyNumber);
  if (!fields.ok()) return 0;
  if (number >= 0 && number < static_cast<double>(scans) && number == std::floor(number)) {
    return static_cast<std::size_t>(number);
  }
  fields.fail(fmt::format("the log has no scan {:.12g}; its scans are numbered 0 to {}", number, scans - 1));
  return 0;
}

/// t1 t2 x y z roll pitch yaw
PoseRelation read_by_stamp(FieldReader& fields, const ScansByStamp& scans) {
  PoseRelation relation;
  relation.scan_1 = read_stamped_scan(fields, scans);
  relation.scan_2 = read_stamped_scan(fields, scans);
  relation.T_1_2.x = fields.number("x", kAnyNumber);
  relation.T_1_2.y = fields.number("y", kAnyNumber);
  for (const char* ignored : {"z", "roll", "pitch"}) fields.number(ignored, kAnyNumber);
  relation.T_1_2.theta = fields.number("yaw", kAnyNumber);
  return relation;
}

/// i1 i2 x y yaw
PoseRelation read_by_number(FieldReader& fields, std::size_t scans) {
  PoseRelation relation;
  relation.scan_1 = read_numbered_scan(fields, scans);
  relation.scan_2 = read_numbered_scan(fields, scans);
  relation.T_1_2 = fields.pose("relation", 1);
  return relation;
}

PoseRelation read_relation(FieldReader& fields, std::size_t field_count, const ScansByStamp& scans,
                           std::size_t scan_count) {
  if (field_count == 8) return read_by_stamp(fields, scans);
  if (field_count == 5) return read_by_number(fields, scan_count);
  fields.fail(fmt::format("has {} fields; a relation has 8 (t1 t2 x y z roll pitch yaw) or 5 (i1 i2 x y yaw)",
                          field_count));
  return {};
}

}  // namespace

Result<std::vector<PoseRelation>> parse_relations(std::string_view text, const std::string& name,
                                                  const LaserLog& log) {
  const ScansByStamp scans(log);
  std::vector<PoseRelation> relations;
  ProblemList problems(name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    const std::size_t field_count = count_fields(line);
    if (field_count == 0 || FieldReader(line).word().front() == '#') continue;
    FieldReader fields(line);
    relations.push_back(read_relation(fields, field_count, scans, log.scans.size()));
    if (!fields.ok()) problems.add(line_number, fields.failure());
  }
  if (!problems.empty()) return problems.take();
  if (relations.empty()) return Problem{{name}, "has no relations"};
  return relations;
}

Result<std::vector<PoseRelation>> read_relations(const std::filesystem::path& path, const LaserLog& log) {
  const Result<std::string> text = read_whole_file(path);
  if (!text) return text.problems();
  return parse_relations(*text, path.string(), log);
}

}  // namespace aisle
