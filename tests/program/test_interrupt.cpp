#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <string_view>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr int kPipeBytes = 4096;

/// The program reads its standard input, a pipe. More bytes than the pipe holds are written once the program
/// reads; the signal is sent before the rest, so it always arrives during the work.
class Interrupt : public WorkplaceWithLog {
 protected:
  void SetUp() override {
    WorkplaceWithLog::SetUp();
    std::signal(SIGPIPE, SIG_IGN);
  }

  ProgramRun interrupted_by(int signal, const Arguments& arguments, const std::string& input) const {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    EXPECT_GE(fcntl(ends[1], F_SETPIPE_SZ, kPipeBytes), 0);
    RunningAisle running(arguments, ends[0]);
    close(ends[0]);
    const std::string bytes = read_bytes(input);
    write_all(ends[1], std::string_view(bytes).substr(0, kPipeBytes + 1));
    running.signal(signal);
    write_all(ends[1], std::string_view(bytes).substr(kPipeBytes + 1));
    close(ends[1]);
    return running.wait();
  }

 private:
  static void write_all(int pipe, std::string_view bytes) {
    for (ssize_t count = 0; !bytes.empty() && (count = write(pipe, bytes.data(), bytes.size())) > 0;) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
  }
};

TEST_F(Interrupt, StopsMappingWithoutLeavingFiles) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ProgramRun run = interrupted_by(signal, {"map", "/dev/stdin", "--out", at("out")}, log());
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err, HasSubstr("interrupted"));
    EXPECT_THAT(names_in(at("out")), IsEmpty());
  }
}

TEST_F(Interrupt, StopsSimulationWithoutLeavingFiles) {
  const ProgramRun run = interrupted_by(SIGINT, {"sim", "log", "/dev/stdin", "--out", at("out")},
                                        AISLE_SOURCE_DIR "/worlds/small-office.yaml");
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(names_in(at("out")), IsEmpty());
}

}  // namespace
}  // namespace aisle
