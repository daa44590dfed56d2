#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aisle/formats/sessions/session_reader.hpp"
#include "live_control.hpp"

namespace aisle {

/// Shows a recorded session over the live server as if it happened now.
class LiveReplay {
 public:
  /// @param control  must outlive the replay
  LiveReplay(std::filesystem::path session, LiveControl& control)
      : session_(std::move(session)), control_(control) {}

  /// Runs until a client stops it; waits at the session's end. Empty on success.
  Problems run();

  /// Answers a call of a service replay/...
  void take_call(const ServiceCall& call);

 private:
  struct KeptMessage {
    SessionTopic topic;
    ros::Stamp_ns stamp = 0;
    std::string cdr;
  };

  Problems open();
  Result<std::vector<KeptMessage>> messages_at(ros::Stamp_ns to);
  Result<std::optional<KeptMessage>> next();
  Problems play();
  ros::Stamp_ns stamp_at(double at_s) const;
  Problems seek(double to_s);
  Result<bool> show_next();
  void tell(double at_s);
  Playback playback() const;
  void show_playback();
  void control(const nlohmann::json& request);

  std::filesystem::path session_;
  LiveControl& control_;
  std::optional<SessionReader> reader_;
  std::deque<KeptMessage> ahead_;  ///< read already, not yet played
  ros::Stamp_ns first_ = 0, last_ = 0, at_ = 0;
  bool is_playing_ = true;
  bool has_ended_ = false;
  bool is_stopped_ = false;
  std::optional<double> seek_to_s_;
  std::optional<Playback> shown_;
};

}  // namespace aisle
