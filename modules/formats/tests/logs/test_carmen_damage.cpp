#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <sstream>

#include "aisle/core/random.hpp"
#include "logs/carmen_lines.hpp"

namespace aisle {
namespace {

std::string small_log() {
  std::string text = "PARAM robot_front_laser_max 50\n";
  for (int i = 0; i < 8; ++i) text += odom(0.1 * i, i) + flaser_of(5, 0.1 * i, i);
  return text;
}

std::size_t whole_scans(const std::string& text) {
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.starts_with("FLASER");
  return count;
}

RC_GTEST_PROP(DamagedCarmen, CutAnywhereKeepsTheWholeScans, (std::uint64_t seed)) {
  Random random(seed);
  const std::string whole = small_log();
  const std::string cut = whole.substr(0, random.index(whole.size() + 1));
  const std::size_t expected = whole_scans(cut);
  const auto carmen = parse_carmen_log(cut, "cut");
  RC_ASSERT(expected == 0 || carmen.ok());
  if (!carmen.ok()) return;
  // The last line may be whole but for its line end, or its last digits.
  RC_ASSERT(carmen->log.scans.size() >= expected);
  RC_ASSERT(carmen->log.scans.size() <= expected + 1);
}

RC_GTEST_PROP(DamagedCarmen, OneBadByteCostsAtMostOneScan, (std::uint64_t seed)) {
  Random random(seed);
  std::string text = small_log();
  const std::size_t at = 32 + random.index(text.size() - 32);
  text[at] = text[at] == '\n' ? '\n' : static_cast<char>(random.index(256));
  const auto carmen = parse_carmen_log(text, "bad");
  RC_ASSERT(carmen.ok());
  RC_ASSERT(carmen->log.scans.size() >= 7);
}

RC_GTEST_PROP(DamagedCarmen, LinesInAnotherOrderAreStillAllTheirScans, (std::uint64_t seed)) {
  Random random(seed);
  std::vector<std::string> lines;
  std::istringstream text(small_log());
  for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
  for (std::size_t i = lines.size(); i > 1; --i) std::swap(lines[i - 1], lines[random.index(i)]);
  std::string shuffled;
  for (const std::string& line : lines) shuffled += line;
  const auto carmen = parse_carmen_log(shuffled, "shuffled");
  RC_ASSERT(carmen.ok());
  RC_ASSERT(carmen->log.scans.size() == 8U);
  for (std::size_t i = 1; i < 8; ++i)
    RC_ASSERT(carmen->log.scans[i].time_s >= carmen->log.scans[i - 1].time_s);
}

}  // namespace
}  // namespace aisle
