#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include <vectrix/space/files/csv_table.hpp>

#include "scenario/place.hpp"

namespace vectrix::cli {

/// Throws CsvError for a column that the table does not have, with the nearest one.
inline void require_column(const CsvTable& table, const std::filesystem::path& file,
                           const std::string& name) {
  const auto& names = table.columns();
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const bool has_no_comma = names.size() == 1 && names.front().find_first_of(";\t") != std::string::npos;
  throw CsvError("table " + file.string() + ": it has no column '" + name + "'" +
                 (has_no_comma ? "; its header has no comma, which stands between the fields of a table"
                               : instead_of(name, names)));
}

}  // namespace vectrix::cli
