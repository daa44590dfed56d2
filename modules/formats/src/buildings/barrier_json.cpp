#include "buildings/barrier_json.hpp"

#include <fmt/format.h>

#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kBarriersMax = 1000;

const char* kind_text(Barrier::Kind kind) {
  return kind == Barrier::Kind::kGlass ? "glass" : "keep_out";
}

void read_kind(const JsonValue& value, Barrier::Kind& kind) {
  if (value.is("glass")) {
    kind = Barrier::Kind::kGlass;
  } else if (value.is("keep_out")) {
    kind = Barrier::Kind::kKeepOut;
  } else {
    value.wrong(R"(is neither "keep_out" nor "glass")");
  }
}

Barrier read_barrier(const JsonValue& value) {
  Barrier barrier;
  if (!value.is_object_of({"kind", "start_m", "end_m"})) return barrier;
  if (const auto kind = value.require("kind")) read_kind(*kind, barrier.kind);
  if (const auto start = value.require("start_m")) start->read_point(barrier.segment.start);
  if (const auto end = value.require("end_m")) end->read_point(barrier.segment.end);
  return barrier;
}

}  // namespace

std::string barriers_json(const std::vector<Barrier>& barriers) {
  std::vector<std::string> texts;
  texts.reserve(barriers.size());
  for (const Barrier& barrier : barriers)
    texts.push_back(fmt::format(R"({{"kind": "{}", "start_m": {}, "end_m": {}}})", kind_text(barrier.kind),
                                point_json(barrier.segment.start, kMillimetreDecimals),
                                point_json(barrier.segment.end, kMillimetreDecimals)));
  return list_json(texts);
}

std::vector<Barrier> read_barriers(const JsonValue& value) {
  std::vector<Barrier> barriers;
  if (!value.is_list_up_to(kBarriersMax)) return barriers;
  barriers.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) barriers.push_back(read_barrier(value.element(i)));
  return barriers;
}

}  // namespace aisle
