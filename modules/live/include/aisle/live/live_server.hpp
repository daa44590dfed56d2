#pragma once
/// The server that shows a mission to browsers and other programs and takes their requests:
/// docs/reference/live-server.md.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/live/drive_command.hpp"
#include "aisle/live/live_folders.hpp"
#include "aisle/live/playback.hpp"
#include "aisle/live/service_call.hpp"
#include "aisle/live/tls_files.hpp"

namespace aisle {

struct LiveServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any free port
  std::string token;          ///< that clients must present; required unless `address` is this machine's own
  std::vector<std::string> origins;  ///< other sites whose pages may connect
  TlsFiles tls;                      ///< if given, only https and wss are accepted
  std::string name = "aisle";
  std::string version;
  LiveFolders folders;
};

/// Runs on its own thread from open() to the destructor. Publishing never waits for a client.
class LiveServer final : public MessageSink {
 public:
  static constexpr std::size_t kConnectionsMax = 32;

  /// Fails if the address is invalid or taken, if other machines can reach it and there is no token, or if
  /// the certificate or the key is unusable.
  static Result<std::unique_ptr<LiveServer>> open(LiveServerOptions options,
                                                  std::vector<LiveService> services);

  ~LiveServer() override;

  std::uint16_t port() const;
  /// "http://127.0.0.1:8765/"
  std::string url() const;
  /// Other machines can connect, and the connection is not encrypted.
  bool can_be_overheard() const;

  /// Sends a message to the subscribers of its topic; call from one thread at a time.
  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;
  /// Sends the vehicle's time to all clients.
  void take_time(ros::Stamp_ns stamp);
  /// Shows the replay of a session to viewers that can control one; nullopt: it has ended. Their requests
  /// come as calls of "replay/control" with `plays`, `rate` and perhaps `seek_to_ns`, to the mailbox of
  /// "replay/play"; what has changed must be shown before they are answered.
  void show_playback(const std::optional<Playback>& playback);
  /// Latched messages so far are no longer sent to clients that join later.
  void forget_latched();
  /// Closes every connection once its client has taken all that was sent before; nobody can connect any more.
  /// clients() tells how many are left.
  void say_goodbye();

  /// The newest drive commands from the holder of the lease.
  DriveInbox& drive();
  bool lease_is_held() const;
  std::size_t clients() const;

 private:
  class Engine;

  explicit LiveServer(std::unique_ptr<Engine> engine);

  std::unique_ptr<Engine> engine_;
};

}  // namespace aisle
