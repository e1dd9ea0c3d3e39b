#pragma once

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lookout::core {

/// A number in its shortest form that reads back to the same value.
std::string shortest(double value);

/// A CSV file read strictly: a header line that names the columns, then rows of as many fields.
class CsvTable {
 public:
  /// Reads the whole file. Columns of `required` must be in the header; others may be.
  /// @throws InputError naming file and line: not readable, a column missing, or a row of another length.
  CsvTable(const std::string& path, std::span<const std::string_view> required);

  std::size_t num_rows() const { return rows_.size(); }        ///< Rows below the header.
  bool has(std::string_view column) const;                     ///< Whether the header names the column.
  bool empty(std::size_t row, std::string_view column) const;  ///< Whether the field is blank.

  /// The field as a finite number. @throws InputError naming file, line and column otherwise.
  double number(std::size_t row, std::string_view column) const;
  /// The field as a whole number. @throws InputError naming file, line and column otherwise.
  std::int64_t integer(std::size_t row, std::string_view column) const;
  /// The field as it stands; valid as long as the table. @throws InputError where the header lacks the
  /// column.
  const std::string& text(std::size_t row, std::string_view column) const;

  /// Refuses a field: throws InputError `FILE:LINE: COLUMN MESSAGE`.
  [[noreturn]] void fail(std::size_t row, std::string_view column, const std::string& message) const;

 private:
  std::optional<std::size_t> find(std::string_view column) const;
  const std::string& field(std::size_t row, std::string_view column) const;

  std::string path_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// Writes a CSV file row by row; the file takes its name only when `close` succeeds, so nothing half-written
/// stays.
class CsvWriter {
 public:
  /// @throws InputError where the file cannot be created.
  CsvWriter(const std::string& path, std::string_view header);
  ~CsvWriter();
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  CsvWriter& number(double value);         ///< Appends a number in its shortest round-trip form.
  CsvWriter& integer(std::int64_t value);  ///< Appends a whole number.
  /// Appends a text as it is; it must hold neither comma nor line break.
  CsvWriter& text(std::string_view value);
  CsvWriter& blank();  ///< Appends an empty field.
  void end_row();      ///< Ends the row. Fields are not counted against the header.
  void close();        ///< Flushes and renames. @throws std::runtime_error where the disk refuses.

 private:
  void separate();

  std::string path_;
  std::ofstream file_;
  bool row_started_ = false;
  bool closed_ = false;
};

}  // namespace lookout::core
