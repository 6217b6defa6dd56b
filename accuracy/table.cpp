#include "table.hpp"

#include <cstdio>

namespace vectrix::accuracy {
namespace {

std::string printed(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

// Escapes the text: a bar in it must not end a column of the table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

}  // namespace

std::string Table::where(const Found& worst, std::size_t sample) {
  const std::string number = "sample " + std::to_string(sample);
  return worst.place.empty() ? number : worst.place + " = " + printed("%.3g", worst.value) + ", " + number;
}

std::string Table::markdown() const {
  std::string text;
  for (const Section& section : sections_) {
    text += "\n## " + section.title + "\n\n" + section.text +
            "\n\n| function | domain | samples | max, ulp | rms, ulp | worst at | scale | promise, ulp | "
            "why | verdict |\n| --- | --- | ---: | ---: | ---: | --- | --- | ---: | --- | --- |\n";
    for (const Row& row : rows_) {
      if (row.section != section.title) continue;
      for (const std::string& word : {row.function, row.domain, std::to_string(row.samples),
                                      printed("%.2f", row.largest), printed("%.2f", row.rms), row.worst,
                                      row.scale, printed("%.1f", row.promise.ulps), row.promise.reason}) {
        text += "| " + cell(word) + " ";
      }
      text += row.passed() ? "| pass |\n" : "| **FAIL** |\n";
    }
  }
  return text;
}

}  // namespace vectrix::accuracy
