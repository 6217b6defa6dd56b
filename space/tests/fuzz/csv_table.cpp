// Any file is a table, each of whose fields has a text and is or is no number, or is refused.
#include <vectrix/space/files/csv_table.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
  const vectrix::fuzz::InputFile file(bytes, size);
  const auto table = vectrix::CsvTable::read(file.path(), {"x"});
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto& column : table.columns()) {
      if (table.text(row, column).size() > size) std::abort();
    }
    static_cast<void>(table.number(row, "x"));
  }
  return 0;
} catch (const vectrix::CsvError&) {
  return 0;
}
