#include "core/files/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/files/text_file.hpp"
#include "core/files/time_text.hpp"
#include "core/input_error.hpp"

namespace lookout::core {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr char kQuote = '"', kTab = '\t';
/// The line with which a spreadsheet is told the separator, which follows it.
constexpr std::string_view kSeparatorHint = "sep=";
constexpr std::string_view kNoBreakSpace = "\xC2\xA0", kMinusSign = "\xE2\x88\x92";

std::string_view trimmed(std::string_view text, std::string_view blanks = kBlanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The separator of a header: what stands most often between its names.
char separator_of(std::string_view header) {
  char best = ',';
  for (const char candidate : {';', kTab, '|'})
    if (std::count(header.begin(), header.end(), candidate) > std::count(header.begin(), header.end(), best))
      best = candidate;
  return best;
}

void replace_all(std::string& text, std::string_view from, char to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1))
    text.replace(at, from.size(), 1, to);
}

/// With the blanks and signs of a word processor as those of a keyboard.
std::string typed(std::string text) {
  replace_all(text, kNoBreakSpace, ' ');
  replace_all(text, kMinusSign, '-');
  return text;
}

char lower_case(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char one, char other) { return lower_case(one) == lower_case(other); });
}

bool all_empty(std::span<const std::string> fields) {
  return std::all_of(fields.begin(), fields.end(), [](const std::string& field) { return field.empty(); });
}

/// Takes the first line off `rest`; it ends with a line feed, a carriage return, or both.
std::string_view take_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end);
  if (rest.starts_with("\r\n"))
    rest.remove_prefix(2);
  else if (!rest.empty())
    rest.remove_prefix(1);
  return line;
}

/// Takes a field in quotes off `rest`, from behind the first of them; two quotes are one. False where it
/// stays open.
bool take_quoted(std::string_view& rest, std::string& field) {
  while (!rest.empty()) {
    const char letter = rest.front();
    rest.remove_prefix(1);
    if (letter != kQuote)
      field += letter;
    else if (rest.starts_with(kQuote))
      field += kQuote, rest.remove_prefix(1);
    else
      return true;
  }
  return false;
}

template <class Number>
bool parse(const std::string& text, Number& value) {
  const char* begin = text.data() + (text.starts_with('+') && !text.starts_with("+-") ? 1 : 0);
  const char* stop = text.data() + text.size();
  const auto [end, error] = std::from_chars(begin, stop, value);
  return error == std::errc() && end == stop;
}

}  // namespace

std::string shortest(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc() ? std::string(buffer, end) : std::string("nan");
}

CsvTable::CsvTable(const std::string& path, std::span<const std::string_view> required) : path_(path) {
  read(typed(read_text_file(path, "a CSV file")), required);
  require_columns(required);
}

void CsvTable::read(std::string_view content, std::span<const std::string_view> required) {
  for (std::size_t number = 1; !content.empty(); ++number) {
    const std::string_view whole = take_line(content);
    if (trimmed(whole).empty()) continue;
    if (header_.empty())
      read_header(trimmed(whole), number, required);
    else if (!trimmed(whole).starts_with('#'))
      read_row(whole, number);
  }
}

void CsvTable::read_row(std::string_view line, std::size_t number) {
  std::vector<std::string> fields = split(line, number);
  if (all_empty(fields)) return;  // As spreadsheets write their empty rows.
  // And separators at the end of every row, where the header has none.
  if (fields.size() > header_.size() && all_empty(std::span(fields).subspan(header_.size())))
    fields.resize(header_.size());
  if (fields.size() != header_.size())
    throw InputError(path_ + ":" + std::to_string(number) + ": " + std::to_string(fields.size()) +
                     " fields, expected " + std::to_string(header_.size()));
  rows_.push_back(std::move(fields));
  lines_.push_back(number);
}

/// A line behind `#` is the header if it names what is required, else a remark.
void CsvTable::read_header(std::string_view line, std::size_t number,
                           std::span<const std::string_view> required) {
  if (same_but_for_case(line.substr(0, kSeparatorHint.size()), kSeparatorHint) &&
      line.size() <= kSeparatorHint.size() + 1)
    return;
  const bool is_remark = line.starts_with('#');
  if (is_remark) line = trimmed(line.substr(1));
  separator_ = separator_of(line);
  header_ = split(line, number);
  const auto missing = [this](std::string_view column) { return !has(column); };
  if (is_remark && std::any_of(required.begin(), required.end(), missing)) return header_.clear();
  for (std::size_t i = 0; i < header_.size(); ++i) {
    if (find(header_[i]) != i)
      throw InputError(path_ + ":" + std::to_string(number) + ": column " + shown(header_[i]) +
                       " is named twice");
  }
}

void CsvTable::require_columns(std::span<const std::string_view> required) const {
  if (header_.empty()) throw InputError(path_ + ": is empty; expected a line that names the columns");
  for (const auto column : required) {
    if (has(column)) continue;
    std::string found;
    for (const auto& name : header_) found += (found.empty() ? "" : " ") + name;
    throw InputError(path_ + ":1: column `" + std::string(column) +
                     "` is missing from the header, which has " + shown(found) +
                     (header_.size() > 1 ? "" : "; expected names between commas, semicolons or tabs"));
  }
}

std::vector<std::string> CsvTable::split(std::string_view line, std::size_t number) const {
  const std::string_view blanks = separator_ == kTab ? kBlanks.substr(0, 1) : kBlanks;
  std::vector<std::string> fields;
  for (;;) {
    const bool quoted = trimmed(line, blanks).starts_with(kQuote);
    std::string field;
    if (quoted) {
      line.remove_prefix(line.find(kQuote) + 1);
      if (!take_quoted(line, field))
        throw InputError(path_ + ":" + std::to_string(number) + ": a quote is not closed on its line");
    }
    const std::size_t end = line.find(separator_);
    const std::string_view rest = trimmed(line.substr(0, end));  // No separator is in it.
    fields.push_back(quoted ? field + std::string(rest) : std::string(rest));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  auto it = std::find(header_.begin(), header_.end(), column);
  if (it == header_.end())
    it = std::find_if(header_.begin(), header_.end(),
                      [column](const std::string& name) { return same_but_for_case(name, column); });
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

std::string CsvTable::number_text(std::size_t row, std::string_view column) const {
  std::string text = field(row, column);
  if (separator_ == ',') return text;
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && text.find_first_of(".,", comma + 1) == std::string::npos)
    text[comma] = '.';
  return text;
}

double CsvTable::number_or_nan(std::size_t row, std::string_view column) const {
  double value = 0.0;
  if (!parse(number_text(row, column), value))
    fail(row, column, "got " + shown(field(row, column)) + ", expected a number");
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

double CsvTable::number(std::size_t row, std::string_view column) const {
  double value = 0.0;
  if (!parse(number_text(row, column), value) || !std::isfinite(value))
    fail(row, column, "got " + shown(field(row, column)) + ", expected a finite number");
  return value;
}

std::int64_t CsvTable::integer(std::size_t row, std::string_view column) const {
  std::int64_t value = 0;
  if (!parse(field(row, column), value))
    fail(row, column, "got " + shown(field(row, column)) + ", expected a whole number");
  return value;
}

std::int64_t CsvTable::time(std::size_t row, std::string_view column) const {
  const auto utime = parse_time(number_text(row, column));
  if (!utime)
    fail(row, column, "got " + shown(field(row, column)) + ", expected seconds, at most 9e9 (microseconds?)");
  return *utime;
}

void CsvTable::fail(std::size_t row, std::string_view column, const std::string& message) const {
  throw InputError(path_ + ":" + std::to_string(lines_.at(row)) + ": " + std::string(column) + ": " +
                   message);
}

CsvWriter::CsvWriter(const std::string& path, std::string_view header) : path_(path) {
  require_plain_target(path);
  file_.open(path + ".part");
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
CsvWriter& CsvWriter::time(std::int64_t utime) {
  return text(time_text(utime));
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
  std::error_code failed;
  std::filesystem::rename(path_ + ".part", path_, failed);
  if (failed) throw std::runtime_error(path_ + ": could not be written: " + failed.message());
  closed_ = true;
}

}  // namespace lookout::core
