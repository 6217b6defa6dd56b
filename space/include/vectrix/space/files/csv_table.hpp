#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/vector.hpp>

namespace vectrix {

/// A table file that cannot be used: the text contains file, line, column (name and number) and reason.
class VECTRIX_EXPORT CsvError : public BadInput {
 public:
  using BadInput::BadInput;
};

/// A text table: one header line of column names, then one line of fields per row, separated by commas. Lines
/// that begin with '#' before the header are comments. Blanks around a field are ignored, a line may end with
/// CR LF, and a byte order mark may precede the first line. Quotation marks are not supported. Every line
/// must have a line end, the last too: a file that ends within a line may have been cut. Rows are counted
/// from 0, lines and columns in messages from 1.
class VECTRIX_EXPORT CsvTable {
 public:
  /// Throws CsvError if the file cannot be read, is empty, ends within a line, lacks a required column, has
  /// two columns of one name, or has a row with more or fewer fields than the header.
  static CsvTable read(const std::filesystem::path& file,
                       std::initializer_list<std::string_view> required_columns);

  [[nodiscard]] std::size_t rows() const { return lines_.size(); }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }

  /// The text of the field. Throws CsvError for a column or row that the table does not have.
  [[nodiscard]] const std::string& text(std::size_t row, std::string_view column) const;
  /// The field as a finite number, times 10^shift and rounded once: kilometres in metres by the shift 3.
  /// Throws CsvError if it is anything else.
  [[nodiscard]] double number(std::size_t row, std::string_view column, int shift = 0) const;
  /// make(text) of the field, such as an epoch: table.value(row, "time_utc", Epoch::from_utc). A BadInput
  /// that make throws becomes a CsvError with file, line, column and its text.
  template <class Make>
    requires std::invocable<const Make&, const std::string&>
  [[nodiscard]] auto value(std::size_t row, std::string_view column, const Make& make) const {
    const std::string& written = text(row, column);
    try {
      return make(written);
    } catch (const CsvError&) {
      throw;
    } catch (const BadInput& error) {
      refuse(row, column, error.what());
    }
  }
  /// Throws CsvError for a field that the caller cannot use, with file, line, column and the given reason.
  [[noreturn]] void refuse(std::size_t row, std::string_view column, const std::string& reason) const;

 private:
  explicit CsvTable(std::filesystem::path file);

  void read_header(const std::string& line, std::initializer_list<std::string_view> required_columns);
  void read_row(const std::string& line, std::size_t line_number);
  [[nodiscard]] std::size_t field(std::size_t row, std::string_view column) const;
  [[noreturn]] void fail(std::size_t line_number, std::size_t column, const std::string& reason) const;

  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<std::string> fields_;  // row by row
  std::vector<std::size_t> lines_;   // line number of each row
  std::size_t header_line_ = 0;
};

/// Claims that three columns of a row are coordinates in F, in the coherent SI unit U:
///     read_vector<si::length>(in<Itrf>, table, row, {"x_m", "y_m", "z_m"})
/// Throws CsvError as CsvTable::number does.
template <VectorUnit U, Frame F>
Vector<F, U> read_vector(In<F>, const CsvTable& table, std::size_t row,
                         const std::array<std::string_view, 3>& columns) {
  return vector<U>(in<F>, Eigen::Vector3d(table.number(row, columns[0]), table.number(row, columns[1]),
                                          table.number(row, columns[2])));
}

}  // namespace vectrix
