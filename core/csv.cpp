#include "core/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "core/input_error.hpp"

namespace lookout::core {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  for (std::size_t start = 0;;) {
    const std::size_t comma = line.find(',', start);
    fields.emplace_back(line.substr(start, comma == std::string_view::npos ? comma : comma - start));
    if (comma == std::string_view::npos) return fields;
    start = comma + 1;
  }
}

}  // namespace

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : std::string("nan");
}

CsvTable::CsvTable(const std::string& path, std::span<const std::string_view> required) : path_(path) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; expected a CSV file");
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) continue;
    std::vector<std::string> fields = split(line);
    if (header_.empty()) {
      header_ = std::move(fields);
      continue;
    }
    if (fields.size() != header_.size())
      throw InputError(path + ":" + std::to_string(number) + ": " + std::to_string(fields.size()) +
                       " fields, expected " + std::to_string(header_.size()));
    rows_.push_back(std::move(fields));
    lines_.push_back(number);
  }
  for (const auto column : required) {
    if (!has(column))
      throw InputError(path + ":1: column `" + std::string(column) + "` is missing from the header");
  }
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto it = std::find(header_.begin(), header_.end(), column);
  if (it == header_.end()) return std::nullopt;
  return static_cast<std::size_t>(it - header_.begin());
}

bool CsvTable::has(std::string_view column) const {
  return find(column).has_value();
}

const std::string& CsvTable::field(std::size_t row, std::string_view column) const {
  return rows_.at(row).at(find(column).value());
}

bool CsvTable::empty(std::size_t row, std::string_view column) const {
  return field(row, column).empty();
}

const std::string& CsvTable::text(std::size_t row, std::string_view column) const {
  return field(row, column);
}

double CsvTable::number(std::size_t row, std::string_view column) const {
  const std::string& text = field(row, column);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail(row, column, "got `" + text + "`, expected a finite number");
  return value;
}

std::int64_t CsvTable::integer(std::size_t row, std::string_view column) const {
  const std::string& text = field(row, column);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    fail(row, column, "got `" + text + "`, expected a whole number");
  return value;
}

void CsvTable::fail(std::size_t row, std::string_view column, const std::string& message) const {
  throw InputError(path_ + ":" + std::to_string(lines_.at(row)) + ": " + std::string(column) + ": " +
                   message);
}

CsvWriter::CsvWriter(const std::string& path, std::string_view header) : path_(path), file_(path + ".part") {
  if (!file_) throw InputError(path + ": cannot be written");
  file_ << header << '\n';
}

CsvWriter::~CsvWriter() {
  if (closed_) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(path_ + ".part", ignored);
}

void CsvWriter::separate() {
  if (row_started_) file_ << ',';
  row_started_ = true;
}

CsvWriter& CsvWriter::number(double value) {
  return text(shortest(value));
}
CsvWriter& CsvWriter::integer(std::int64_t value) {
  return text(std::to_string(value));
}
CsvWriter& CsvWriter::blank() {
  return text("");
}

CsvWriter& CsvWriter::text(std::string_view value) {
  separate();
  file_ << value;
  return *this;
}

void CsvWriter::end_row() {
  file_ << '\n';
  row_started_ = false;
}

void CsvWriter::close() {
  file_.close();
  if (!file_) throw std::runtime_error(path_ + ": could not be written completely");
  std::filesystem::rename(path_ + ".part", path_);
  closed_ = true;
}

}  // namespace lookout::core
