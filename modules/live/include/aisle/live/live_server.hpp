#pragma once
/// The server that shows a mission to browsers and other programs, and brings what they ask for:
/// docs/reference/live-server.md.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/live/drive_command.hpp"
#include "aisle/live/live_folders.hpp"
#include "aisle/live/service_call.hpp"
#include "aisle/live/tls_files.hpp"

namespace aisle {

struct LiveServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any that is free
  std::string token;          ///< that clients must know; needed where `address` is not this machine's own
  TlsFiles tls;               ///< given: https and wss alone are spoken
  std::string name = "aisle";
  std::string version;
  LiveFolders folders;
};

/// Runs on a thread of its own from `open` to the destructor. Publishing never waits for a client.
class LiveServer final : public MessageSink {
 public:
  static constexpr std::size_t kConnectionsMax = 32;

  /// A problem if the address is none or is taken, if it can be reached from elsewhere and there is no token,
  /// or if certificate and key are not as they must be.
  static Result<std::unique_ptr<LiveServer>> open(LiveServerOptions options,
                                                  std::vector<LiveService> services);

  ~LiveServer() override;

  std::uint16_t port() const;
  /// "http://127.0.0.1:8765/"
  std::string url() const;
  /// Others than this machine can be connected, and what they are reported is not encrypted.
  bool can_be_overheard() const;

  /// Sends a message to who has subscribed to its topic; from one thread at a time.
  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;
  /// Tells all what time it is for the vehicle.
  void take_time(ros::Stamp_ns stamp);
  /// What was latched is not sent any more to who comes later.
  void forget_latched();

  /// The newest drive commands of who holds the lease.
  DriveInbox& drive();
  bool lease_is_held() const;
  std::size_t clients() const;

 private:
  class Engine;

  explicit LiveServer(std::unique_ptr<Engine> engine);

  std::unique_ptr<Engine> engine_;
};

}  // namespace aisle
