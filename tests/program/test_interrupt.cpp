#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The program reads its input from a pipe. Opening the pipe succeeds once the program waits at the other
/// end; the signal is sent before the input, so it always arrives during the work.
class Interrupt : public WorkplaceWithLog {
 protected:
  void SetUp() override {
    WorkplaceWithLog::SetUp();
    std::signal(SIGPIPE, SIG_IGN);
    ASSERT_EQ(mkfifo(at("pipe").c_str(), 0600), 0);
  }

  ProgramRun interrupted_by(int signal, const Arguments& arguments, const std::string& input) const {
    RunningAisle running(arguments);
    const int pipe = open(at("pipe").c_str(), O_WRONLY | O_CLOEXEC);
    running.signal(signal);
    const std::string bytes = read_bytes(input);
    std::string_view rest = bytes;
    for (ssize_t count = 0; !rest.empty() && (count = write(pipe, rest.data(), rest.size())) > 0;) {
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
    close(pipe);
    return running.wait();
  }
};

TEST_F(Interrupt, StopsMappingWithoutLeavingFiles) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ProgramRun run = interrupted_by(signal, {"map", at("pipe"), "--out", at("out")}, log());
    EXPECT_EQ(run.exit_code, 130);
    EXPECT_THAT(run.out, IsEmpty());
    EXPECT_THAT(run.err, HasSubstr("interrupted"));
    EXPECT_THAT(names_in(at("out")), IsEmpty());
  }
}

TEST_F(Interrupt, StopsSimulationWithoutLeavingFiles) {
  const ProgramRun run = interrupted_by(SIGINT, {"sim", "log", at("pipe"), "--out", at("out")},
                                        AISLE_SOURCE_DIR "/worlds/small-office.yaml");
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(names_in(at("out")), IsEmpty());
}

}  // namespace
}  // namespace aisle
