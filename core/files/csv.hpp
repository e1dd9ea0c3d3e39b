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

/// A CSV file read strictly: a header line that names the columns, then rows of as many fields. Read as
/// spreadsheets and scripts write it: with a byte order mark, with any line ends, with quotes, with blanks
/// around fields, with a `#` before the header and remarks behind a `#`, with empty rows and empty fields
/// behind the last, with names in capitals, and with semicolons, tabs or bars in place of commas, numbers
/// then with a decimal point or comma.
class CsvTable {
 public:
  /// Reads the whole file. Columns of `required` must be in the header; others may be.
  /// @throws InputError naming file and line: not readable, not text, a column missing or named twice, a
  /// quote left open, or a row of another length.
  CsvTable(const std::string& path, std::span<const std::string_view> required);

  std::size_t num_rows() const { return rows_.size(); }        ///< Rows below the header.
  bool has(std::string_view column) const;                     ///< Whether the header names the column.
  bool empty(std::size_t row, std::string_view column) const;  ///< Whether the field is blank.

  /// The field as a finite number. @throws InputError naming file, line and column otherwise.
  double number(std::size_t row, std::string_view column) const;
  /// The same, but NaN for text that says nan or inf in any spelling.
  double number_or_nan(std::size_t row, std::string_view column) const;
  /// The field as a whole number. @throws InputError naming file, line and column otherwise.
  std::int64_t integer(std::size_t row, std::string_view column) const;
  /// Seconds as microseconds. @throws InputError naming file, line and column.
  std::int64_t time(std::size_t row, std::string_view column) const;
  /// The field as it stands; valid as long as the table. @throws InputError where the header lacks the
  /// column.
  const std::string& text(std::size_t row, std::string_view column) const;

  const std::string& path() const { return path_; }                   ///< Of the file, as it was given.
  std::size_t line(std::size_t row) const { return lines_.at(row); }  ///< In the file, from 1.

  /// Refuses a field: throws InputError `FILE:LINE: COLUMN MESSAGE`.
  [[noreturn]] void fail(std::size_t row, std::string_view column, const std::string& message) const;

 private:
  void read(std::string_view content, std::span<const std::string_view> required);
  void read_row(std::string_view line, std::size_t number);
  void read_header(std::string_view line, std::size_t number, std::span<const std::string_view> required);
  void require_columns(std::span<const std::string_view> required) const;
  std::vector<std::string> split(std::string_view line, std::size_t number) const;
  std::optional<std::size_t> find(std::string_view column) const;
  const std::string& field(std::size_t row, std::string_view column) const;
  std::string number_text(std::size_t row, std::string_view column) const;

  std::string path_;
  char separator_ = ',';
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<std::size_t> lines_;
};

/// Writes a CSV file row by row; the file takes its name only when `close` succeeds, so nothing half-written
/// stays.
class CsvWriter {
 public:
  /// @throws InputError where the file cannot be created, or is a device or a directory.
  CsvWriter(const std::string& path, std::string_view header);
  ~CsvWriter();
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  CsvWriter& number(double value);         ///< Appends a number in its shortest round-trip form.
  CsvWriter& time(std::int64_t utime);     ///< Appends microseconds as seconds, exactly.
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
