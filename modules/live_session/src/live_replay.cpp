#include "live_replay.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "aisle/formats/sessions/session_summary.hpp"
#include "live_arguments.hpp"

namespace aisle {
namespace {

constexpr double kRateMin = 0.1, kRateMax = 20;

constexpr ros::Stamp_ns kSoon = 1'000'000'000;

bool is_truth(const SessionTopic& topic) {
  return topic.name.starts_with("/truth");
}

double seconds_of(ros::Stamp_ns duration) {
  return static_cast<double>(duration) / 1e9;
}

}  // namespace

Problems LiveReplay::run() {
  const auto summary = summarise_session(session_);
  if (!summary) return summary.problems();
  first_ = summary->first;
  last_ = summary->last;
  control_.forget_past(first_);
  if (Problems problems = open(); !problems.empty()) return problems;
  try {
    return play();
  } catch (const Interrupted&) {
    if (!control_.was_stopped()) throw;
    return {};
  }
}

Problems LiveReplay::open() {
  auto reader = SessionReader::open(session_);
  if (!reader) return reader.problems();
  reader_.emplace(std::move(*reader));
  ahead_.clear();
  at_ = first_;
  has_ended_ = false;
  return {};
}

Problems LiveReplay::play() {
  while (!is_stopped_) {
    if (const auto to_s = std::exchange(seek_to_s_, std::nullopt)) {
      if (Problems problems = seek(*to_s); !problems.empty()) return problems;
    }
    tell(seconds_of(at_ - first_));
    show_playback();
    if (!is_playing_ || has_ended_) {
      control_.rest();
      control_.serve(kPausedPoll_s);
      control_.report("replay", 0, 0);
      continue;
    }
    const auto shown = show_next();
    if (!shown) return shown.problems();
    has_ended_ = !*shown;
  }
  return {};
}

Result<std::optional<LiveReplay::KeptMessage>> LiveReplay::next() {
  if (!ahead_.empty()) {
    std::optional<KeptMessage> first(std::move(ahead_.front()));
    ahead_.pop_front();
    return first;
  }
  const auto message = reader_->next();
  if (!message) return message.problems();
  if (!*message) return std::optional<KeptMessage>();
  return std::optional(KeptMessage{(*message)->topic, (*message)->stamp, std::string((*message)->cdr)});
}

/// Shows one message; one that begins a cycle is shown when it is due.
Result<bool> LiveReplay::show_next() {
  const auto message = next();
  if (!message) return message.problems();
  if (!*message) return false;
  const auto& [topic, stamp, cdr] = **message;
  const bool begins_cycle = stamp != at_;
  at_ = stamp;
  if (!is_truth(topic)) control_.take(topic, stamp, cdr);
  if (begins_cycle) control_.report("replay", 0, 0);
  return true;
}

ros::Stamp_ns LiveReplay::stamp_at(double at_s) const {
  return first_ +
         static_cast<ros::Stamp_ns>(std::llround(std::clamp(at_s, 0.0, seconds_of(last_ - first_)) * 1e9));
}

/// Jumps to a time and shows what there was to be seen then.
Problems LiveReplay::seek(double to_s) {
  const ros::Stamp_ns to = stamp_at(to_s);
  if (Problems problems = open(); !problems.empty()) return problems;
  control_.forget_past(first_);
  const auto messages = messages_at(to);
  if (!messages) return messages.problems();
  for (const KeptMessage& message : *messages) control_.take(message.topic, message.stamp, message.cdr);
  at_ = to;
  control_.rest();
  return {};
}

/// The latest message of every topic; where there is none so early, the first one soon after.
Result<std::vector<LiveReplay::KeptMessage>> LiveReplay::messages_at(ros::Stamp_ns to) {
  const auto topics = static_cast<std::size_t>(
      std::count_if(reader_->topics().begin(), reader_->topics().end(), std::not_fn(is_truth)));
  std::map<std::string, KeptMessage> shown;
  while (shown.size() < topics || ahead_.empty()) {
    auto message = reader_->next();
    if (!message) return message.problems();
    if (!*message || (*message)->stamp > to + kSoon) break;
    const auto& [topic, stamp, cdr] = **message;
    if (is_truth(topic)) continue;
    KeptMessage kept{topic, stamp, std::string(cdr)};
    if (stamp > to) {
      shown.try_emplace(topic.name, kept);
      ahead_.push_back(std::move(kept));
    } else {
      control_.take_past(topic, stamp, cdr);
      shown.insert_or_assign(topic.name, std::move(kept));
    }
  }
  std::vector<KeptMessage> messages;
  messages.reserve(shown.size());
  for (auto& [name, message] : shown) messages.push_back(std::move(message));
  std::stable_sort(messages.begin(), messages.end(),
                   [](const KeptMessage& a, const KeptMessage& b) { return a.stamp < b.stamp; });
  return messages;
}

void LiveReplay::tell(double at_s) {
  LiveState& state = control_.state();
  state.replay = {{"session", session_.filename().string()}, {"from_s", 0},
                  {"to_s", seconds_of(last_ - first_)},      {"at_s", at_s},
                  {"playing", is_playing_ && !has_ended_},   {"rate", control_.rate()}};
}

/// As it will be once it has jumped to where it was asked to.
Playback LiveReplay::playback() const {
  const bool has_ended = has_ended_ && !seek_to_s_;
  return {.first = first_,
          .last = last_,
          .at = seek_to_s_ ? stamp_at(*seek_to_s_) : at_,
          .rate = control_.rate(),
          .status = has_ended     ? PlaybackStatus::kEnded
                    : is_playing_ ? PlaybackStatus::kPlaying
                                  : PlaybackStatus::kPaused,
          .did_seek = seek_to_s_.has_value()};
}

/// Shows what has changed; that it goes on, the stamps tell. A jump is shown before what there is to be seen.
void LiveReplay::show_playback() {
  const Playback now = playback();
  const bool is_news =
      !shown_ || now.did_seek || shown_->did_seek || now.status != shown_->status || now.rate != shown_->rate;
  if (!is_news) return;
  control_.show_playback(now);
  shown_ = now;
}

/// What a viewer asks by the protocol's own message.
void LiveReplay::control(const nlohmann::json& request) {
  is_playing_ = request.at("plays").get<bool>();
  control_.set_rate(std::clamp(request.at("rate").get<double>(), kRateMin, kRateMax));
  if (request.contains("seek_to_ns")) {
    const auto to =
        std::clamp<std::uint64_t>(request.at("seek_to_ns").get<std::uint64_t>(),
                                  static_cast<std::uint64_t>(first_), static_cast<std::uint64_t>(last_));
    seek_to_s_ = seconds_of(static_cast<ros::Stamp_ns>(to) - first_);
  } else if (is_playing_ && has_ended_) {
    seek_to_s_ = 0;
  }
}

void LiveReplay::take_call(const ServiceCall& call) {
  const std::string& service = call.service();
  LiveArguments arguments(call.arguments());
  if (service == "replay/play") {
    is_playing_ = true;
    if (has_ended_) seek_to_s_ = 0;
  } else if (service == "replay/pause") {
    is_playing_ = false;
  } else if (service == "replay/seek") {
    const auto to_s = arguments.number("to_s");
    if (!to_s) return call.refuse("to_s: must be a number of seconds from the session's beginning");
    seek_to_s_ = *to_s;
  } else if (service == "replay/rate") {
    const auto rate = arguments.number("rate");
    if (!rate || *rate < kRateMin || *rate > kRateMax) return call.refuse("rate: must be from 0.1 to 20");
    control_.set_rate(*rate);
  } else if (service == "replay/control") {
    control(call.arguments());
  } else if (service == "replay/stop") {
    is_stopped_ = true;
  } else {
    return call.refuse("a session is being replayed; replay/stop ends it");
  }
  show_playback();
  call.answer(nlohmann::ordered_json::object());
}

}  // namespace aisle
