#include "bags/sqlite_pages.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "bags/unpacking.hpp"

namespace aisle {
namespace {

constexpr std::size_t kFileHeader_bytes = 100;
constexpr char kTableLeaf = 13;  ///< first byte of a page with rows

std::uint64_t big_endian_number(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

/// Passes a number of one to nine bytes; nullopt if the bytes end within it.
std::optional<std::uint64_t> take_varint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(bytes.size(), 9); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    const bool is_last = i == 8 || byte < 128;
    number = i == 8 ? number << 8 | byte : number << 7 | (byte & 127U);
    if (!is_last) continue;
    bytes.remove_prefix(i + 1);
    return number;
  }
  return std::nullopt;
}

/// The bytes of a column of this serial type that is a whole number; nullopt for other types.
std::optional<std::size_t> integer_bytes(std::uint64_t type) {
  constexpr std::array<std::size_t, 7> kBytes{0, 1, 2, 3, 4, 6, 8};
  if (type >= 1 && type <= 6) return kBytes[type];
  if (type == 8 || type == 9) return 0;
  return std::nullopt;
}

std::int64_t integer(std::uint64_t type, std::string_view bytes) {
  if (type == 8 || type == 9) return static_cast<std::int64_t>(type - 8);
  const std::uint64_t unused_bits = 64 - 8 * bytes.size();
  return static_cast<std::int64_t>(big_endian_number(bytes) << unused_bits) >> unused_bits;
}

/// Where the columns of a message are in its record.
struct MessageColumns {
  std::int64_t topic_id = 0, timestamp = 0;
  std::size_t data_begin = 0;
  std::uint64_t data_bytes = 0;
};

/// @param record  its beginning
/// @return nullopt if the record is no message: the number is null, for it is the row's, then two numbers and
/// a blob
std::optional<MessageColumns> message_columns(std::string_view record) {
  std::string_view rest = record;
  const auto header_bytes = take_varint(rest);
  if (!header_bytes || *header_bytes > record.size()) return std::nullopt;
  std::array<std::uint64_t, 4> types{};
  for (std::uint64_t& type : types) {
    const auto next = take_varint(rest);
    if (!next) return std::nullopt;
    type = *next;
  }
  if (record.size() - rest.size() != *header_bytes) return std::nullopt;  // more columns
  const auto topic_bytes = integer_bytes(types[1]), stamp_bytes = integer_bytes(types[2]);
  const bool is_blob = types[3] >= 12 && types[3] % 2 == 0;
  if (types[0] != 0 || !topic_bytes || !stamp_bytes || !is_blob) return std::nullopt;
  if (rest.size() < *topic_bytes + *stamp_bytes) return std::nullopt;
  return MessageColumns{integer(types[1], rest.substr(0, *topic_bytes)),
                        integer(types[2], rest.substr(*topic_bytes, *stamp_bytes)),
                        static_cast<std::size_t>(*header_bytes) + *topic_bytes + *stamp_bytes,
                        (types[3] - 12) / 2};
}

}  // namespace

Result<SqlitePages> SqlitePages::open(const std::filesystem::path& path) {
  auto file = ByteStream::open(path);
  if (!file) return file.problems();
  const std::string_view header = file->peek(kFileHeader_bytes);
  SqlitePages pages;
  if (header.size() == kFileHeader_bytes) {
    pages.page_bytes_ = big_endian_number(header.substr(16, 2));
    if (pages.page_bytes_ == 1) pages.page_bytes_ = 65536;
    pages.usable_bytes_ = pages.page_bytes_ - big_endian_number(header.substr(20, 1));
    pages.pages_ = big_endian_number(header.substr(28, 4));
  }
  if (pages.page_bytes_ < 512 || pages.usable_bytes_ < 480)
    return Problem{{path.string()}, "is cut off within its header, or damaged there"};
  pages.file_ = std::move(*file);
  return pages;
}

std::vector<SqlitePages::Row> SqlitePages::messages() {
  std::vector<Row> rows;
  for (std::uint64_t number = 2; number <= file_.size() / page_bytes_; ++number) take_rows(number, rows);
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.id < b.id; });
  const auto is_same = [](const Row& a, const Row& b) {
    return a.id == b.id;
  };  // an unused page keeps its old rows
  rows.erase(std::unique(rows.begin(), rows.end(), is_same), rows.end());
  return rows;
}

std::string_view SqlitePages::data(const Row& row) {
  const std::string_view bytes = record(row);
  const auto columns = message_columns(bytes);
  if (!columns || columns->data_begin + columns->data_bytes > bytes.size()) return {};
  return bytes.substr(columns->data_begin, static_cast<std::size_t>(columns->data_bytes));
}

std::string_view SqlitePages::page(std::uint64_t number) {
  if (number == 0 || number > file_.size() / page_bytes_) return {};
  file_.seek((number - 1) * page_bytes_);
  const std::string_view bytes = file_.peek(static_cast<std::size_t>(page_bytes_));
  return bytes.size() == page_bytes_ ? bytes.substr(0, static_cast<std::size_t>(usable_bytes_))
                                     : std::string_view();
}

std::uint64_t SqlitePages::local_bytes(std::uint64_t payload_bytes) const {
  if (payload_bytes <= usable_bytes_ - 35) return payload_bytes;
  const std::uint64_t least = (usable_bytes_ - 12) * 32 / 255 - 23;
  const std::uint64_t filled = least + (payload_bytes - least) % (usable_bytes_ - 4);
  return filled <= usable_bytes_ - 35 ? filled : least;
}

void SqlitePages::take_rows(std::uint64_t page_number, std::vector<Row>& rows) {
  std::string_view bytes = page(page_number);
  if (bytes.empty() || bytes[0] != kTableLeaf) return;
  const auto cells = static_cast<std::size_t>(big_endian_number(bytes.substr(3, 2)));
  for (std::size_t i = 0; i < cells && 8 + 2 * i + 2 <= usable_bytes_; ++i) {
    bytes = page(page_number);  // following a row's other pages moved on
    const auto cell = static_cast<std::size_t>(big_endian_number(bytes.substr(8 + 2 * i, 2)));
    if (const auto row = row_at(page_number, cell)) rows.push_back(*row);
  }
}

std::optional<SqlitePages::Row> SqlitePages::row_at(std::uint64_t page_number, std::size_t cell) {
  const std::string_view bytes = page(page_number);
  if (cell >= bytes.size()) return std::nullopt;
  std::string_view rest = bytes.substr(cell);
  const auto payload_bytes = take_varint(rest), id = take_varint(rest);
  if (!payload_bytes || !id || *payload_bytes > file_.size()) return std::nullopt;
  const std::uint64_t local = local_bytes(*payload_bytes);
  if (local > rest.size()) return std::nullopt;
  const auto columns = message_columns(rest.substr(0, static_cast<std::size_t>(local)));
  if (!columns || columns->data_begin + columns->data_bytes != *payload_bytes) return std::nullopt;
  const Row row{static_cast<std::int64_t>(*id), columns->topic_id, columns->timestamp,
                (page_number - 1) * page_bytes_ + static_cast<std::uint64_t>(rest.data() - bytes.data()),
                *payload_bytes};
  const bool is_whole = local == *payload_bytes || !record(row).empty();
  return is_whole ? std::optional(row) : std::nullopt;
}

std::string_view SqlitePages::record(const Row& row) {
  if (row.payload_bytes > kUnpackedMax_bytes) return {};
  const auto local = static_cast<std::size_t>(local_bytes(row.payload_bytes));
  const auto size = static_cast<std::size_t>(row.payload_bytes);
  char* const memory = buffer_.room(size);
  file_.seek(row.payload);
  const std::string_view first = file_.peek(local + 4);
  if (first.size() < std::min(local + 4, size)) return {};
  std::memcpy(memory, first.data(), local);
  std::uint64_t next = local < size ? big_endian_number(first.substr(local, 4)) : 0;
  for (std::size_t taken = local; taken < size;) {
    const std::string_view bytes = page(next);
    if (bytes.empty()) return {};
    next = big_endian_number(bytes.substr(0, 4));
    const std::size_t part = std::min(size - taken, bytes.size() - 4);
    std::memcpy(memory + taken, bytes.data() + 4, part);
    taken += part;
  }
  return {memory, size};
}

}  // namespace aisle
