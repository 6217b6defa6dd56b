#include <algorithm>
#include <cmath>

#include <vectrix/space/files/csv_table.hpp>

#include "shifted_number.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.emplace_back(detail::trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable::CsvTable(std::filesystem::path file) : file_(std::move(file)) {}

CsvTable CsvTable::read(const std::filesystem::path& file,
                        std::initializer_list<std::string_view> required_columns) {
  const auto content = detail::read_lines(file);
  if (!content) throw CsvError("table " + file.string() + ": cannot be read");

  CsvTable table{file};
  std::size_t line_number = 0;
  for (const std::string& line : content->lines) {
    ++line_number;
    if (table.header_line_ == 0 && line.starts_with('#')) continue;
    if (detail::trimmed(line).empty()) {
      const auto rest = content->lines.begin() + static_cast<std::ptrdiff_t>(line_number);
      if (table.header_line_ != 0 && std::all_of(rest, content->lines.end(), [](const std::string& later) {
            return detail::trimmed(later).empty();
          }))
        break;
      throw CsvError("table " + file.string() + ", line " + detail::text(line_number) +
                     ": the line is empty; a table has empty lines at its end only");
    }
    if (const auto quote = line.find('"'); quote != std::string::npos) {
      const auto column = static_cast<std::size_t>(
          std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(quote), ','));
      table.fail(line_number, column, "quotation marks are not supported");
    }
    if (table.header_line_ == 0) {
      table.header_line_ = line_number;
      table.read_header(line, required_columns);
    } else {
      table.read_row(line, line_number);
    }
  }
  if (table.header_line_ == 0)
    throw CsvError("table " + file.string() + ": is empty, not even a header line");
  if (!content->whole) {
    table.fail(line_number, split(content->lines.back()).size() - 1,
               "the last line has no line end; if the file is complete, add one");
  }
  return table;
}

void CsvTable::read_header(const std::string& line,
                           std::initializer_list<std::string_view> required_columns) {
  columns_ = split(line);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].empty()) fail(header_line_, i, "the column has no name");
    const auto first = std::find(columns_.begin(), columns_.end(), columns_[i]);
    if (first != columns_.begin() + static_cast<std::ptrdiff_t>(i)) {
      fail(header_line_, i, "column " + detail::text(first - columns_.begin() + 1) + " has the same name");
    }
  }
  for (const auto name : required_columns) {
    if (std::find(columns_.begin(), columns_.end(), name) == columns_.end()) {
      throw CsvError("table " + file_.string() + ", line " + detail::text(header_line_) + ": no column '" +
                     std::string{name} + "' in the header '" + line + "'");
    }
  }
}

void CsvTable::read_row(const std::string& line, std::size_t line_number) {
  const auto fields = split(line);
  if (fields.size() != columns_.size()) {
    fail(line_number, fields.size(),
         detail::text(fields.size()) + " fields instead of " + detail::text(columns_.size()));
  }
  fields_.insert(fields_.end(), fields.begin(), fields.end());
  lines_.push_back(line_number);
}

const std::string& CsvTable::text(std::size_t row, std::string_view column) const {
  return fields_[row * columns_.size() + field(row, column)];
}

double CsvTable::number(std::size_t row, std::string_view column, int shift) const {
  const std::string& written = text(row, column);
  if (const auto value = detail::parse_shifted(written, shift)) return *value;
  const bool is_finite = detail::is_finite_number(written);
  if (!is_finite && !detail::parse_number(written))
    refuse(row, column, "'" + written + "' is not a number" + detail::exponent_fault(written));
  refuse(
      row, column,
      "'" + written + "'" + (shift == 0 ? "" : " times 10^" + detail::text(shift)) +
          (is_finite ? std::string{": "} + detail::number_fault(written, shift) : " is not a finite number"));
}

void CsvTable::refuse(std::size_t row, std::string_view column, const std::string& reason) const {
  const std::size_t which = field(row, column);
  fail(lines_[row], which, reason);
}

std::size_t CsvTable::field(std::size_t row, std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) {
    throw CsvError("table " + file_.string() + ": asked for a column '" + std::string{column} +
                   "', which it does not have");
  }
  if (row >= rows()) {
    throw CsvError("table " + file_.string() + ": asked for row " + detail::text(row) + " of " +
                   detail::text(rows()));
  }
  return static_cast<std::size_t>(found - columns_.begin());
}

void CsvTable::fail(std::size_t line_number, std::size_t column, const std::string& reason) const {
  std::string place = "table " + file_.string() + ", line " + detail::text(line_number) + ", column " +
                      detail::text(column + 1);
  if (column < columns_.size()) place += " ('" + columns_[column] + "')";
  throw CsvError(place + ": " + reason);
}

}  // namespace vectrix
