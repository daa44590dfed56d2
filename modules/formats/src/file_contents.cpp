#include "aisle/formats/file_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "field_reader.hpp"

namespace aisle {
namespace {

using namespace std::string_view_literals;

struct FileSignature {
  std::string_view bytes;
  const char* description;
};

constexpr std::array<FileSignature, 31> kSignatures = {{
    {"\x89PNG"sv, "a PNG image"},
    {"\xff\xd8\xff"sv, "a JPEG image"},
    {"GIF8"sv, "a GIF image"},
    {"BM"sv, "a BMP image"},
    {"II*\0"sv, "a TIFF image"},
    {"MM\0*"sv, "a TIFF image"},
    {"P1"sv, "a portable bitmap image"},
    {"P2"sv, "a portable graymap image"},
    {"P3"sv, "a portable pixmap image"},
    {"P4"sv, "a portable bitmap image"},
    {"P5"sv, "a portable graymap image"},
    {"P6"sv, "a portable pixmap image"},
    {"#ROSBAG"sv, "a ROS 1 bag"},
    {"\x89MCAP"sv, "an MCAP recording"},
    {"AC10"sv, "an AutoCAD drawing (DWG); save it as DXF"},
    {"%!PS"sv, "a PostScript file; save it as PDF"},
    {"PK\x03\x04"sv, "a zip archive; unpack it first"},
    {"7z\xbc\xaf"sv, "a 7z archive; unpack it first"},
    {"Rar!"sv, "a rar archive; unpack it first"},
    {"\xfd\x37zXZ"sv, "an xz file; unpack it first"},
    {"\x28\xb5\x2f\xfd"sv, "a zstd file; unpack it first"},
    {"\x04\x22\x4d\x18"sv, "an lz4 file; unpack it first"},
    {"# .PCD"sv, "a point cloud (PCD)"},
    {"VERSION .7"sv, "a point cloud (PCD)"},
    {"VERSION 0.7"sv, "a point cloud (PCD)"},
    {"ply"sv, "a point cloud or mesh (PLY)"},
    {"LASF"sv, "a point cloud (LAS)"},
    {"%PDF"sv, "a PDF document"},
    {"SQLite format 3"sv, "an SQLite database that is no ROS 2 bag"},
    {"\x7f"
     "ELF"sv,
     "a program"},
    {"\x89HDF"sv, "an HDF5 file"},
}};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

bool looks_like_text(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f';
  });
}

/// The first two lines have fields, and as many.
bool looks_like_table(std::string_view head) {
  const auto commas = [](std::string_view line) { return std::count(line.begin(), line.end(), ','); };
  const auto first = commas(take_line(head));
  return first > 0 && first == commas(take_line(head));
}

std::string_view without_leading_space(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

std::optional<std::string> known_text(std::string_view head) {
  const std::string_view text = without_leading_space(head);
  const std::string start = lower_case(text.substr(0, 64));
  if (start.starts_with("<!doctype html") || start.starts_with("<html")) return "a web page (HTML)";
  if (start.starts_with("<")) return "an XML file";
  if (!start.starts_with("{") && !start.starts_with("[")) return std::nullopt;
  if (head.find("\"aisle.building\"") != std::string_view::npos) return "a building that aisle learned";
  return "a JSON file";
}

}  // namespace

bool is_tar_archive(std::string_view head) {
  constexpr std::size_t kMagicAt = 257;
  return head.size() > kMagicAt + 5 && head.substr(kMagicAt, 5) == "ustar";
}

std::optional<std::string> known_contents(std::string_view head) {
  if (head.empty()) return "empty";
  for (const FileSignature& signature : kSignatures) {
    if (head.starts_with(signature.bytes)) return signature.description;
  }
  if (head.starts_with("RIFF") && head.substr(0, 12).ends_with("WEBP")) return "a WebP image";
  if (is_tar_archive(head)) return "a tar archive; unpack it first";
  return looks_like_text(head) ? known_text(head) : std::nullopt;
}

std::string describe_contents(std::string_view head) {
  if (auto known = known_contents(head)) return *known;
  if (!looks_like_text(head)) return "binary data of no known kind";
  if (looks_like_table(head)) {
    return "a table, but its header does not name time_s and range_0_m (docs/formats/laser_csv.md)";
  }
  return "a text of another kind, beginning '" + printable(head.substr(0, head.find('\n'))) + "'";
}

}  // namespace aisle
