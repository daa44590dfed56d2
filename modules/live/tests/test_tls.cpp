#include <gmock/gmock.h>
#include <openssl/ssl.h>
#include <unistd.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <filesystem>
#include <fstream>

#include "aisle/live/live_server.hpp"
#include "live_client.hpp"
#include "test_certificate.hpp"

namespace aisle {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace fs = std::filesystem;
namespace http = beast::http;
using testing::HasSubstr;
using TlsClientStream = beast::ssl_stream<beast::tcp_stream>;

class TlsServer : public testing::Test {
 protected:
  TlsServer() { fs::create_directories(directory); }
  ~TlsServer() override { fs::remove_all(directory); }

  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name) << text;
    return (directory / name).string();
  }

  Result<std::unique_ptr<LiveServer>> open(const TlsFiles& files) {
    return LiveServer::open({.port = 0, .tls = files, .version = "1.2"}, {{"echo", false, &calls}});
  }

  std::unique_ptr<LiveServer> open() {
    auto server = open({file("cert.pem", made.certificate_pem), file("key.pem", made.key_pem)});
    if (!server) throw std::runtime_error(to_string(server.problems()));
    return std::move(*server);
  }

  /// A connection that accepts the server's certificate and no other.
  TlsClientStream connect(std::uint16_t port) {
    tls.add_certificate_authority(asio::buffer(made.certificate_pem));
    tls.set_verify_mode(asio::ssl::verify_peer);
    TlsClientStream stream(io, tls);
    beast::get_lowest_layer(stream).connect({asio::ip::make_address("127.0.0.1"), port});
    stream.handshake(asio::ssl::stream_base::client);
    return stream;
  }

  ServiceMailbox calls;
  const TestCertificate made = make_certificate();
  const fs::path directory = fs::temp_directory_path() / ("aisle-tls-" + std::to_string(getpid()));
  asio::io_context io;
  asio::ssl::context tls{asio::ssl::context::tls_client};
};

std::string body_of_healthz(TlsClientStream& stream, const std::string& host) {
  http::request<http::empty_body> request{http::verb::get, "/healthz", 11};
  request.set(http::field::host, host);
  http::write(stream, request);
  beast::flat_buffer buffer;
  http::response<http::string_body> response;
  http::read(stream, buffer, response);
  return response.body();
}

/// The server's reply to bytes that are not TLS; empty if it hung up without one.
std::string answer_to(std::uint16_t port, const std::string& bytes) {
  asio::io_context io;
  asio::ip::tcp::socket socket(io);
  socket.connect({asio::ip::make_address("127.0.0.1"), port});
  asio::write(socket, asio::buffer(bytes));
  std::string said;
  boost::system::error_code end;
  asio::read(socket, asio::dynamic_buffer(said), end);
  return said;
}

TEST_F(TlsServer, AnswersOverHttpsAgainAndAgain) {
  const auto server = open();
  EXPECT_THAT(server->url(), testing::StartsWith("https://127.0.0.1:"));
  TlsClientStream stream = connect(server->port());
  const std::string host = "127.0.0.1:" + std::to_string(server->port());
  for (int i = 0; i < 2; ++i) EXPECT_EQ(body_of_healthz(stream, host), R"({"ok":true,"version":"1.2"})");
}

TEST_F(TlsServer, GreetsClientsOfTheProtocol) {
  const auto server = open();
  beast::websocket::stream<TlsClientStream> socket(connect(server->port()));
  socket.set_option(beast::websocket::stream_base::decorator([](beast::websocket::request_type& request) {
    request.set(http::field::sec_websocket_protocol, "foxglove.websocket.v1");
  }));
  socket.handshake("127.0.0.1:" + std::to_string(server->port()), "/");
  beast::flat_buffer buffer;
  socket.read(buffer);
  EXPECT_THAT(beast::buffers_to_string(buffer.data()), HasSubstr("serverInfo"));
  socket.close(beast::websocket::close_code::normal);
}

TEST_F(TlsServer, TellsPlainHttpClientsToUseHttps) {
  const auto server = open();
  const LiveHttpReply reply = live_http(server->port(), "GET", "/healthz");
  EXPECT_EQ(reply.status, 400);
  EXPECT_THAT(reply.body, HasSubstr("https"));
  EXPECT_ANY_THROW(LiveClient(server->port()));
}

TEST_F(TlsServer, RefusesWhatIsOlderThanTls12) {
  const auto server = open();
  SSL_CTX_set_max_proto_version(tls.native_handle(), TLS1_1_VERSION);
  SSL_CTX_set_security_level(tls.native_handle(), 0);
  EXPECT_THROW(connect(server->port()), boost::system::system_error);
}

TEST_F(TlsServer, DropsGarbageAndStillServesOthers) {
  const auto server = open();
  const std::string hello = "\x16\x03\x01\x02";  // a handshake with a valid beginning
  for (std::size_t i = 0; i < 2 * LiveServer::kConnectionsMax; ++i) {
    EXPECT_THAT(answer_to(server->port(), std::string(200, 'x')), HasSubstr("400"));
    EXPECT_THAT(answer_to(server->port(), hello + std::string(600, '\xff')), testing::Not(HasSubstr("200")));
  }
  TlsClientStream stream = connect(server->port());
  EXPECT_THAT(body_of_healthz(stream, "localhost"), HasSubstr("true"));
}

TEST_F(TlsServer, SaysWhichFileIsWrongAndWhy) {
  const std::string certificate = file("cert.pem", made.certificate_pem);
  const std::string key = file("key.pem", made.key_pem);
  const std::string absent = (directory / "absent.pem").string();
  const auto says = [&](const TlsFiles& files, const std::string& where, const std::string& what) {
    const auto server = open(files);
    ASSERT_FALSE(server);
    EXPECT_THAT(to_string(server.problems()), testing::AllOf(HasSubstr(where), HasSubstr(what)));
  };
  says({certificate, {}}, "--key", "go together");
  says({{}, key}, "--cert", "go together");
  says({absent, key}, absent, "no such file");
  says({certificate, absent}, absent, "no such file");
  says({key, key}, key, "no certificate in PEM form");
  says({certificate, certificate}, certificate, "no private key in PEM form");
  says({certificate, file("other.pem", make_certificate().key_pem)}, "other.pem",
       "does not belong to the certificate in " + certificate);
  says({certificate, file("secret.pem", make_certificate("guarded").key_pem)}, "secret.pem", "pass phrase");
}

}  // namespace
}  // namespace aisle
