#include "bags/bag_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/median.hpp"

namespace aisle {
namespace {

constexpr double kOffClock_s = 0.5;  ///< more between two streams is not the time that a message takes
constexpr double kDisorder_s = 0.5;  ///< up to this, stamps that go back are messages in the wrong order
constexpr double kLongStep_s = 60;   ///< a longer step must be one for the recorder, too
constexpr double kSameJump_s = 5;    ///< two streams see one and the same jump of their clock
constexpr double kGapMin_s = 2;
constexpr double kNominal_s = 0.1;  ///< the step of a stream that shows none

/// The median of log stamp - stamp over the messages that have a stamp.
double median_delay_s(const MessageStream& stream) {
  std::vector<double> delays_s;
  for (const MessageTime& time : stream.times) {
    if (time.stamp != 0) delays_s.push_back(static_cast<double>(time.log_stamp - time.stamp) * 1e-9);
  }
  return delays_s.empty() ? 0 : median(std::move(delays_s));
}

double median_step_s(const std::vector<double>& times_s) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double step_s = times_s[i] - times_s[i - 1];
    if (step_s > 0 && step_s < kLongStep_s) steps_s.push_back(step_s);
  }
  return steps_s.empty() ? kNominal_s : median(std::move(steps_s));
}

/// Gives messages without a stamp the time at which they must have been made.
std::vector<double> stamped_s(const MessageStream& stream, const std::string& file, Problems& warnings) {
  const auto without = std::count_if(stream.times.begin(), stream.times.end(),
                                     [](const MessageTime& time) { return time.stamp == 0; });
  const bool by_log = 2 * without > static_cast<std::ptrdiff_t>(stream.times.size());
  if (without > 0)
    warnings.push_back({{file, 0, stream.topic},
                        fmt::format("{} of {} messages have no stamp; when they were recorded is taken",
                                    without, stream.times.size())});
  const double delay_s = by_log ? 0 : median_delay_s(stream);
  std::vector<double> times_s;
  for (const MessageTime& time : stream.times)
    times_s.push_back(by_log || time.stamp == 0 ? ros::stamp_s(time.log_stamp) - delay_s
                                                : ros::stamp_s(time.stamp));
  return times_s;
}

/// Makes one clock of those of several machines.
void align_clocks(std::span<const MessageStream> streams, const std::string& file,
                  std::vector<std::vector<double>>& times_s, Problems& warnings) {
  const auto delay_of = [&](std::size_t i) {
    std::vector<double> delays_s;
    for (std::size_t k = 0; k < times_s[i].size(); ++k)
      delays_s.push_back(ros::stamp_s(streams[i].times[k].log_stamp) - times_s[i][k]);
    return delays_s.empty() ? 0 : median(std::move(delays_s));
  };
  const double first_s = delay_of(0);
  for (std::size_t i = 1; i < streams.size(); ++i) {
    const double delay_s = delay_of(i);
    if (times_s[i].empty() || std::abs(delay_s - first_s) <= kOffClock_s) continue;
    warnings.push_back({{file, 0, streams[i].topic},
                        fmt::format("is recorded {:.2f} s after its stamps, {} {:.2f} s: two clocks; its "
                                    "stamps are shifted by {:.2f} s",
                                    delay_s, streams[0].topic, first_s, delay_s - first_s)});
    for (double& time_s : times_s[i]) time_s += delay_s - first_s;
  }
}

/// Lets the clock of all streams go on where it jumped.
class ClockMender {
 public:
  ClockMender(std::span<const MessageStream> streams, std::vector<std::vector<double>>& times_s)
      : streams_(streams), times_s_(times_s), states_(streams.size()) {
    for (std::size_t i = 0; i < streams.size(); ++i) states_[i].usual_step_s = median_step_s(times_s[i]);
  }

  /// In the order of recording over all streams, for a jump that one stream has seen waits for the others.
  void mend(const std::string& file, Problems& warnings) {
    while (State* const stream = next_recorded()) mend_next(*stream);
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State& state = states_[i];
      if (state.jumps > 0)
        warnings.push_back(
            {{file, state.first_jump, streams_[i].topic},
             fmt::format("the clock jumps here by {:.3f} s ({} jumps in all); it goes on as if it had not, "
                         "in the order of recording",
                         state.jump_s, state.jumps)});
      if (state.disordered > 0)
        warnings.push_back({{file, state.first_disorder, streams_[i].topic},
                            fmt::format("{} stamps are older than the one before", state.disordered)});
    }
  }

 private:
  struct State {
    std::size_t next = 0;
    std::size_t used = 0;  ///< jumps of the clock that this stream has seen
    double shift_s = 0;
    double usual_step_s = 0;
    long jumps = 0, first_jump = 0, disordered = 0, first_disorder = 0;
    double jump_s = 0;
  };

  State* next_recorded() {
    State* first = nullptr;
    long number = 0;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const std::size_t next = states_[i].next;
      if (next == times_s_[i].size()) continue;
      if (first != nullptr && streams_[i].times[next].number >= number) continue;
      first = &states_[i];
      number = streams_[i].times[next].number;
    }
    return first;
  }

  void mend_next(State& state) {
    const auto i = static_cast<std::size_t>(&state - states_.data());
    const std::size_t k = state.next++;
    double& time_s = times_s_[i][k];
    time_s += state.shift_s;
    if (k == 0) return;
    const MessageTime& now = streams_[i].times[k];
    const double before_s = times_s_[i][k - 1];
    const double log_step_s = static_cast<double>(now.log_stamp - streams_[i].times[k - 1].log_stamp) * 1e-9;
    const double step_s = time_s - before_s;
    const bool is_back = step_s < -kDisorder_s;
    const bool is_far = step_s > kLongStep_s && std::abs(step_s - log_step_s) > 0.1 * step_s;
    if (is_back || is_far) {
      if (state.jumps++ == 0) {
        state.first_jump = now.number;
        state.jump_s = step_s;
      }
      const bool log_goes_on = log_step_s >= 0 && log_step_s < kLongStep_s;
      const double shift_s = shared_shift(state, (log_goes_on ? log_step_s : state.usual_step_s) - step_s);
      state.shift_s += shift_s;
      time_s += shift_s;
    } else if (step_s < 0 && state.disordered++ == 0) {
      state.first_disorder = now.number;
    }
    time_s = std::max(time_s, before_s);
  }

  /// All streams are shifted by the same at one jump of their clock, so that they stay together.
  double shared_shift(State& state, double needed_s) {
    if (state.used < shifts_s_.size() && std::abs(shifts_s_[state.used] - needed_s) < kSameJump_s)
      return shifts_s_[state.used++];
    shifts_s_.push_back(needed_s);
    state.used = shifts_s_.size();
    return needed_s;
  }

  std::span<const MessageStream> streams_;
  std::vector<std::vector<double>>& times_s_;
  std::vector<State> states_;
  std::vector<double> shifts_s_;
};

void tell_gaps(const MessageStream& stream, const std::vector<double>& times_s, const std::string& file,
               Problems& warnings) {
  const double gap_s = std::max(kGapMin_s, 10 * median_step_s(times_s));
  long gaps = 0;
  double longest_s = 0;
  long before = 0;  // number of the message before the longest gap
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    const double step_s = times_s[i] - times_s[i - 1];
    if (step_s <= gap_s) continue;
    ++gaps;
    if (step_s <= longest_s) continue;
    longest_s = step_s;
    before = stream.times[i - 1].number;
  }
  if (gaps > 0)
    warnings.push_back({{file, before, stream.topic},
                        fmt::format("nothing for {:.1f} s after this message{}", longest_s,
                                    gaps == 1 ? "" : fmt::format(", the longest of {} gaps", gaps))});
}

}  // namespace

std::vector<std::vector<double>> stream_times_s(std::span<const MessageStream> streams,
                                                const std::string& file, Problems& warnings) {
  std::vector<std::vector<double>> times_s;
  for (const MessageStream& stream : streams) times_s.push_back(stamped_s(stream, file, warnings));
  align_clocks(streams, file, times_s, warnings);
  ClockMender(streams, times_s).mend(file, warnings);
  for (std::size_t i = 0; i < streams.size(); ++i) tell_gaps(streams[i], times_s[i], file, warnings);
  return times_s;
}

}  // namespace aisle
