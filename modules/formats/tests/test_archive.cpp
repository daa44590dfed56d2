#include <gmock/gmock.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "aisle/formats/archive.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr std::size_t kTarBlock = 512;
constexpr char kFileEntry = '0', kLinkEntry = '2';

/// One entry of a tar archive, written by its specification (POSIX ustar).
std::string tar_entry(const std::string& name, const std::string& content, char kind = kFileEntry,
                      const std::string& target = "") {
  std::string header(kTarBlock, '\0');
  const auto put = [&](std::size_t at, const std::string& text) { header.replace(at, text.size(), text); };
  const auto octal = [](std::size_t number, int digits) {
    std::ostringstream text;
    text << std::oct << number;
    return std::string(static_cast<std::size_t>(digits) - text.str().size(), '0') + text.str();
  };
  put(0, name);
  put(100, "0000644");
  put(124, octal(content.size(), 11));
  put(136, octal(0, 11));
  put(156, std::string(1, kind));
  put(157, target);
  put(257, std::string("ustar\0", 6) + "00");
  put(148, "        ");
  const auto sum =
      std::accumulate(header.begin(), header.end(), std::size_t{0},
                      [](std::size_t so_far, char c) { return so_far + static_cast<unsigned char>(c); });
  put(148, octal(sum, 6) + std::string("\0 ", 2));
  std::string padded = content;
  padded.resize((content.size() + kTarBlock - 1) / kTarBlock * kTarBlock, '\0');
  return header + padded;
}

std::string tar_of(const std::string& entries) {
  return entries + std::string(2 * kTarBlock, '\0');
}

class Archives : public testing::Test {
 protected:
  Archives() : folder_(fs::temp_directory_path() / ("aisle-archives-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~Archives() override { fs::remove_all(folder_); }
  Archives(const Archives&) = delete;
  Archives& operator=(const Archives&) = delete;

  fs::path file(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  fs::path gzip_file(const std::string& name, const std::string& bytes) const {
    const gzFile packed = gzopen((folder_ / name).c_str(), "wb");
    gzwrite(packed, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(packed);
    return folder_ / name;
  }
  static std::string why_not(const fs::path& archive) {
    SilentProgress silent;
    const auto unpacked = UnpackedArchive::open(archive, silent);
    return unpacked ? "" : to_string(unpacked.problems());
  }

 private:
  fs::path folder_;
};

std::string bytes_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(Archives, HoldWhatWasPackedAndNameItByItsPlace) {
  SilentProgress silent;
  const std::string tar = tar_of(tar_entry("lab/run/a.log", "first") + tar_entry("lab/run/b.log", "second"));
  for (const fs::path& archive : {file("lab.tar", tar), gzip_file("lab.tar.gz", tar)}) {
    ASSERT_TRUE(is_archive(archive));
    fs::path root;
    {
      const auto unpacked = UnpackedArchive::open(archive, silent);
      ASSERT_TRUE(unpacked.ok()) << to_string(unpacked.problems());
      root = unpacked->root();
      EXPECT_EQ(root.filename(), "run");
      EXPECT_EQ(bytes_of(root / "b.log"), "second");
      EXPECT_EQ(unpacked->renamed((root / "b.log").string() + ":3: bad"),
                archive.string() + "/lab/run/b.log:3: bad");
      EXPECT_TRUE(unpacked->warnings().empty());
    }
    EXPECT_FALSE(fs::exists(root)) << "it goes with the object";
  }
}

TEST_F(Archives, OfOneFileAreThatFile) {
  SilentProgress silent;
  const auto unpacked =
      UnpackedArchive::open(file("one.tar", tar_of(tar_entry("deep/one.bag", "x"))), silent);
  ASSERT_TRUE(unpacked.ok());
  EXPECT_EQ(unpacked->root().filename(), "one.bag");
}

TEST_F(Archives, FilesThatAreNoneAreNotTakenForOne) {
  EXPECT_FALSE(is_archive(file("plain.log", "FLASER 1 1.0")));
  EXPECT_FALSE(is_archive(gzip_file("packed.log.gz", "FLASER 1 1.0")));
  EXPECT_FALSE(is_archive(fs::temp_directory_path()));
  EXPECT_FALSE(is_archive("/nowhere/at/all.tar"));
}

TEST_F(Archives, NamesThatLeadOutAreRefused) {
  for (const char* name : {"../out.log", "/tmp/out.log", "a/../../out.log"})
    EXPECT_THAT(why_not(file("out.tar", tar_of(tar_entry(name, "x")))), HasSubstr("leads out of it")) << name;
}

TEST_F(Archives, LinksAreLeftOutWithAWarning) {
  SilentProgress silent;
  const auto unpacked = UnpackedArchive::open(
      file("links.tar", tar_of(tar_entry("a.log", "x") + tar_entry("passwd", "", kLinkEntry, "/etc/passwd"))),
      silent);
  ASSERT_TRUE(unpacked.ok());
  EXPECT_THAT(to_string(unpacked->warnings()), HasSubstr("'passwd' is no regular file"));
  EXPECT_EQ(unpacked->root().filename(), "a.log") << "nothing else was unpacked";
}

TEST_F(Archives, WithoutAFileAreRefused) {
  constexpr char kFolderEntry = '5';
  EXPECT_THAT(why_not(file("folder.tar", tar_of(tar_entry("lab/", "", kFolderEntry)))),
              HasSubstr("holds no files"));
  EXPECT_THAT(why_not(file("link.tar", tar_of(tar_entry("passwd", "", kLinkEntry, "/etc/passwd")))),
              HasSubstr("holds no files"));
}

TEST_F(Archives, BombsAndMultitudesAreRefused) {
  EXPECT_THAT(why_not(gzip_file("bomb.tar.gz", tar_of(tar_entry("zeros.log", std::string(48 << 20, '\0'))))),
              HasSubstr("times its size"));
  std::string many;
  for (int i = 0; i <= 10'000; ++i) many += tar_entry(std::to_string(i), "");
  EXPECT_THAT(why_not(file("many.tar", tar_of(many))), HasSubstr("more than 10000 files"));
}

TEST_F(Archives, CutOffAnywhereTheyGiveWhatCameBeforeWithAWarningOrAProblem) {
  SilentProgress silent;
  const std::string whole =
      tar_of(tar_entry("a.log", std::string(700, 'a')) + tar_entry("b.log", std::string(700, 'b')));
  for (std::size_t length = 1; length < whole.size() - 2 * kTarBlock; length += 37) {
    const auto unpacked = UnpackedArchive::open(file("cut.tar", whole.substr(0, length)), silent);
    if (!unpacked) continue;
    const bool is_at_an_entry = length % kTarBlock == 0;
    EXPECT_TRUE(!unpacked->warnings().empty() || is_at_an_entry) << length;
  }
}

}  // namespace
}  // namespace aisle
