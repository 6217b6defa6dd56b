#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

/// In small letters, as the names of columns are.
inline std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// In capitals.
inline std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// A comma and a number that reads back as the same, for each.
template <class Numbers> void add_fields(std::string& line, const Numbers& numbers) {
  for (const double number : numbers) line += "," + detail::text(number);
}

/// In small letters, with the point: ".csv" of OUT.CSV.
inline std::string ending_of(const std::filesystem::path& file) {
  return small(file.extension().string());
}
/// Whether an attitude kernel of SPICE is to be written.
inline bool is_kernel_name(const std::filesystem::path& file) {
  return ending_of(file) == ".bc";
}
/// Whether a table is to be written, or a message. Throws BadInput for another name.
inline bool is_table_name(const std::filesystem::path& file, const std::string& message) {
  const std::string kind = ending_of(file);
  if (kind != ".csv" && kind != message && kind != ".xml")
    throw BadInput(file.string() + ": the name ends in none of " + message +
                   (message == ".aem" ? ", .bc" : "") +
                   ", .xml, .csv, .czml and .a, which say what to write");
  return kind == ".csv";
}

}  // namespace vectrix::cli
