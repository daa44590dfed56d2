#include "aisle/formats/key_script_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "field_reader.hpp"
#include "problem_list.hpp"

namespace aisle {
namespace {

constexpr double kTimeMax_s = 1e6;
constexpr std::size_t kKeysMax = 100'000;
constexpr std::size_t kLabelMax = 64;
constexpr int kTurnings = 13;

struct KeyWord {
  std::string_view word;
  Key key;
};

const std::array<KeyWord, 11> kWords = {
    {{"up", {.kind = Key::Kind::kUp}},
     {"down", {.kind = Key::Kind::kDown}},
     {"left", {.kind = Key::Kind::kLeft}},
     {"right", {.kind = Key::Kind::kRight}},
     {"stop", {.kind = Key::Kind::kStop}},
     {"quit", {.kind = Key::Kind::kQuit}},
     {"turning", {Key::Kind::kMark, {Mark::Kind::kTurningBegins, ""}}},
     {"turning-ends", {Key::Kind::kMark, {Mark::Kind::kTurningEnds, ""}}},
     {"place", {Key::Kind::kMark, {Mark::Kind::kPlace, ""}}},
     {"route-ends", {Key::Kind::kMark, {Mark::Kind::kStop, ""}}},
     {"way-ends", {Key::Kind::kMark, {Mark::Kind::kStop, ""}}}}};  // of release 0.1

std::optional<double> time_s(std::string_view text) {
  const auto value = parse_number(text);
  if (!value || !(*value >= 0) || *value > kTimeMax_s) return std::nullopt;
  return value;
}

bool is_turning(std::string_view label) {
  const auto number = parse_number(label);
  return number && *number >= 1 && *number <= kTurnings && *number == std::floor(*number);
}

/// What is wrong with the label of a mark; empty if nothing.
std::string label_problem(const Mark& mark) {
  switch (mark.kind) {
    case Mark::Kind::kStop:
      return mark.label.empty() ? "" : fmt::format("'{}' is unexpected", printable(mark.label));
    case Mark::Kind::kPlace:
      return mark.label.empty() || mark.label.size() > kLabelMax
                 ? fmt::format("a place needs a name of at most {} characters", kLabelMax)
                 : "";
    case Mark::Kind::kTurningBegins:
    case Mark::Kind::kTurningEnds:
      return is_turning(mark.label) ? "" : fmt::format("a turning is a number from 1 to {}", kTurnings);
  }
  return "";
}

/// Reads one line; nullopt with the problem in `what` if it is unreadable.
std::optional<TimedKey> parse_line(std::string_view line, std::string& what) {
  FieldReader fields(line);
  const std::string_view times = fields.word(), word = fields.word();
  std::string label;
  for (std::string_view part = fields.word(); !part.empty(); part = fields.word()) {
    label += (label.empty() ? "" : " ") + std::string(part);
  }
  const std::size_t dash = times.find('-');
  const auto from_s = time_s(times.substr(0, dash));
  const auto to_s = dash == std::string_view::npos ? from_s : time_s(times.substr(dash + 1));
  if (!from_s || !to_s || *to_s < *from_s) {
    what = fmt::format("'{}' is not a time FROM or FROM-TO in seconds", printable(times));
    return std::nullopt;
  }
  const auto known =
      std::find_if(kWords.begin(), kWords.end(), [&](const KeyWord& key) { return key.word == word; });
  if (known == kWords.end()) {
    what = fmt::format(
        "'{}' is none of up, down, left, right, stop, quit, turning, turning-ends, place, route-ends",
        printable(word));
    return std::nullopt;
  }
  TimedKey timed{*from_s, *to_s, known->key};
  timed.key.mark.label = label;
  if (timed.key.kind == Key::Kind::kMark) {
    what = label_problem(timed.key.mark);
  } else if (!label.empty()) {
    what = fmt::format("'{}' is unexpected", printable(label));
  }
  if (!what.empty()) return std::nullopt;
  return timed;
}

}  // namespace

Result<std::vector<TimedKey>> parse_key_script(std::string_view text, const std::string& name) {
  std::vector<TimedKey> keys;
  ProblemList problems(name);
  for (long line_number = 1; !text.empty(); ++line_number) {
    const std::string_view line = take_line(text);
    if (FieldReader first(line); first.word().empty() || line.starts_with('#')) continue;
    std::string what;
    if (const auto key = parse_line(line, what)) {
      keys.push_back(*key);
    } else {
      problems.add(line_number, what);
    }
    if (keys.size() > kKeysMax) return Problem{{name, line_number}, "has too many keys"};
  }
  if (!problems.empty()) return problems.take();
  if (keys.empty()) return Problem{{name}, "has no keys: expected lines such as '0-3 up'"};
  return keys;
}

}  // namespace aisle
