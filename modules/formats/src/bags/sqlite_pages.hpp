#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"
#include "bags/byte_stream.hpp"

namespace aisle {

/// The messages of a database that is cut off, found page by page: SQLite itself finds none if the page that
/// lists the others is missing. See sqlite.org/fileformat2.html.
class SqlitePages {
 public:
  struct Row {
    std::int64_t id = 0, topic_id = 0, timestamp = 0;
    std::uint64_t payload = 0;  ///< where its record begins in the file
    std::uint64_t payload_bytes = 0;
  };

  static Result<SqlitePages> open(const std::filesystem::path& path);

  /// Bytes that the header promises.
  std::uint64_t stated_bytes() const { return pages_ * page_bytes_; }
  std::uint64_t bytes() const { return file_.size(); }

  /// The messages of which every byte is there, in the order of their numbers.
  std::vector<Row> messages();
  /// The message itself, valid until the next call.
  std::string_view data(const Row& row);

 private:
  std::string_view page(std::uint64_t number);
  std::uint64_t local_bytes(std::uint64_t payload_bytes) const;
  void take_rows(std::uint64_t page_number, std::vector<Row>& rows);
  std::optional<Row> row_at(std::uint64_t page_number, std::size_t cell);
  /// The whole record of a row, from all pages on which it lies; empty if one is missing.
  std::string_view record(const Row& row);

  ByteStream file_;
  Buffer buffer_;
  std::uint64_t page_bytes_ = 0;
  std::uint64_t usable_bytes_ = 0;  ///< of a page
  std::uint64_t pages_ = 0;         ///< as the header says
};

}  // namespace aisle
