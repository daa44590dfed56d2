#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <thread>

#include "images/drawing.hpp"

namespace aisle {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::seconds kLongest = 30s;
constexpr std::size_t kSvgBytesMax = std::size_t{256} << 20;

/// A file in memory, which takes all of a program's output, however much.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes = {}) : descriptor_(memfd_create("aisle", MFD_CLOEXEC)) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
      if (count <= 0) break;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    ::lseek(descriptor_, 0, SEEK_SET);
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  MemoryFile(MemoryFile&&) = delete;
  MemoryFile& operator=(MemoryFile&&) = delete;

  int descriptor() const { return descriptor_; }

  std::string bytes() const {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    if (size <= 0 || static_cast<std::size_t>(size) > kSvgBytesMax) return {};
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const ssize_t count = ::pread(descriptor_, bytes.data(), bytes.size(), 0);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

 private:
  int descriptor_;
};

struct ProgramEnd {
  enum class Kind { kMissing, kTooLong, kFailed, kDone } kind = Kind::kMissing;
  std::string output;
};

bool ends_well(pid_t process, ProgramEnd::Kind& kind) {
  int status = 0;
  for (auto waited = 0ms; waited < kLongest; waited += 5ms) {
    if (::waitpid(process, &status, WNOHANG) == process) {
      kind =
          WIFEXITED(status) && WEXITSTATUS(status) == 0 ? ProgramEnd::Kind::kDone : ProgramEnd::Kind::kFailed;
      return kind == ProgramEnd::Kind::kDone;
    }
    std::this_thread::sleep_for(5ms);
  }
  ::kill(process, SIGKILL);
  ::waitpid(process, &status, 0);
  kind = ProgramEnd::Kind::kTooLong;
  return false;
}

/// Runs a program of Poppler on these bytes; Poppler itself is under the GPL and is not linked.
template <std::size_t N>
ProgramEnd run_poppler(const std::array<const char*, N>& words, std::string_view input_bytes) {
  const MemoryFile input(input_bytes), output;
  std::array<char*, N + 1> arguments{};
  for (std::size_t i = 0; i < N; ++i) arguments[i] = const_cast<char*>(words[i]);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, output.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const int failure = posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  ProgramEnd end;
  if (failure == 0 && ends_well(process, end.kind)) end.output = output.bytes();
  return end;
}

Problem problem_of(ProgramEnd::Kind kind, const std::string& name) {
  switch (kind) {
    case ProgramEnd::Kind::kMissing:
      return {{name}, "is a PDF, which pdftocairo draws: install poppler-utils, or save the plan as SVG"};
    case ProgramEnd::Kind::kTooLong:
      return {{name}, fmt::format("takes pdftocairo more than {} s to draw", kLongest.count())};
    case ProgramEnd::Kind::kFailed:
    case ProgramEnd::Kind::kDone:
      break;
  }
  return {{name}, "is not a PDF that can be read"};
}

/// Of pdfinfo's "Pages:  3"; 0 if it says none.
int page_count(std::string_view information) {
  constexpr std::string_view kPages = "Pages:";
  const std::size_t at = information.find(kPages);
  if (at == std::string_view::npos) return 0;
  information.remove_prefix(at + kPages.size());
  information.remove_prefix(std::min(information.find_first_not_of(' '), information.size()));
  int pages = 0;
  std::from_chars(information.data(), information.data() + information.size(), pages);
  return pages;
}

}  // namespace

Result<Drawing> read_pdf(std::string_view bytes, const std::string& name) {
  const ProgramEnd information = run_poppler(std::array{"pdfinfo", "-"}, bytes);
  if (information.kind != ProgramEnd::Kind::kDone) return problem_of(information.kind, name);
  const int pages = page_count(information.output);
  if (pages < 1) return Problem{{name}, "has no page"};
  const ProgramEnd drawn =
      run_poppler(std::array{"pdftocairo", "-svg", "-f", "1", "-l", "1", "-", "-"}, bytes);
  if (drawn.kind != ProgramEnd::Kind::kDone) return problem_of(drawn.kind, name);
  Result<Drawing> drawing = read_svg(drawn.output, name);
  if (!drawing) return drawing;
  drawing->unit_m.reset();  // a page's points say nothing of the building
  if (pages > 1) drawing->warnings.push_back({{name}, fmt::format("has {} pages; the first is read", pages)});
  return drawing;
}

}  // namespace aisle
