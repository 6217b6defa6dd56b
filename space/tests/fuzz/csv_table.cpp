// Any file is a table, each of whose fields has a text and is or is no number, or is refused.
#include <vectrix/space/files/csv_table.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto table = fuzz::accepted<CsvError>([&] { return CsvTable::read(file.path(), {"x"}); });
  if (!table) return 0;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    for (const auto& column : table->columns()) {
      if (table->text(row, column).size() > size) std::abort();
    }
    static_cast<void>(fuzz::accepted<CsvError>([&] { return table->number(row, "x"); }));
  }
  return 0;
}
