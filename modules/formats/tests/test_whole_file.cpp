#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

class WholeFile : public testing::Test {
 protected:
  WholeFile() : folder_(fs::temp_directory_path() / ("aisle_whole_file_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~WholeFile() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST_F(WholeFile, WhatWasWrittenIsRead) {
  const std::string bytes("one\0two\n", 8);
  EXPECT_THAT(write_whole_file(folder_ / "file", bytes), IsEmpty());
  EXPECT_EQ(*read_whole_file(folder_ / "file"), bytes);
  EXPECT_FALSE(fs::exists(folder_ / "file.part"));
}

TEST_F(WholeFile, GzipIsUnpackedAndACutOffStreamIsAProblem) {
  const fs::path path = folder_ / "packed.gz";
  const gzFile file = gzopen(path.c_str(), "wb");
  std::string bytes;
  for (int i = 0; i < 20000; ++i) bytes += std::to_string(i * i) + "\n";
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  EXPECT_EQ(*read_whole_file(path), bytes);
  fs::resize_file(path, fs::file_size(path) / 2);
  EXPECT_THAT(to_string(read_whole_file(path).problems()), HasSubstr("the gzip stream is cut off"));
}

TEST_F(WholeFile, WhatIsNoFileOrTooLargeIsAProblem) {
  EXPECT_THAT(to_string(read_whole_file(folder_ / "absent").problems()), HasSubstr("no such file"));
  EXPECT_THAT(to_string(read_whole_file(folder_).problems()), HasSubstr("is a directory"));
  std::ofstream(folder_ / "large") << std::string(2 << 20, 'x');
  EXPECT_THAT(to_string(read_whole_file(folder_ / "large", 1 << 20).problems()),
              HasSubstr("larger than 1 MiB"));
}

TEST_F(WholeFile, WhatCouldWaitForEverIsAProblem) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  (folder_ / "socket").string().copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_THAT(to_string(read_whole_file(folder_ / "pipe").problems()),
              HasSubstr("is a pipe; only regular files and standard input are read"));
  EXPECT_THAT(to_string(read_whole_file(folder_ / "socket").problems()), HasSubstr("is a socket; only"));
  EXPECT_THAT(to_string(read_whole_file("/dev/zero").problems()), HasSubstr("is a device; only"));
  fs::create_symlink("/dev/zero", folder_ / "link");
  EXPECT_THAT(to_string(read_whole_file(folder_ / "link").problems()), HasSubstr("is a device; only"));
  ::close(listener);
}

TEST_F(WholeFile, WhatUnpacksToAbsurdlyMoreIsRefusedEarly) {
  const fs::path path = folder_ / "zeros.gz";
  const gzFile file = gzopen(path.c_str(), "wb");
  const std::string zeros(1 << 20, '\0');
  for (int i = 0; i < 40; ++i) gzwrite(file, zeros.data(), static_cast<unsigned>(zeros.size()));
  gzclose(file);
  EXPECT_THAT(to_string(read_whole_file(path).problems()),
              HasSubstr("more than 200 bytes for every packed one"));
}

TEST_F(WholeFile, AFolderThatIsNotThereIsAProblemOfWriting) {
  EXPECT_THAT(to_string(write_whole_file(folder_ / "absent/file", "x")), HasSubstr("cannot be created"));
}

}  // namespace
}  // namespace aisle
