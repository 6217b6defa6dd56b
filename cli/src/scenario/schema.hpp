#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/units.hpp"

namespace vectrix::cli {

/// What a key of a scenario file may hold.
enum class Kind {
  text,
  name,          // a text without commas, quotation marks and control characters
  whole_number,  // from 1 on
  choice,        // one of some texts, in any capitals
  numbers,       // [1, 2, 3]
  rows,          // [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
  texts,         // ["a", "b"]
  amount,        // "0.5 deg"
  amounts,       // "[1, 2, 3] deg"
  axis,          // "-z of body", "[0, 0.1, 1] of body"
  epoch,         // 2023-04-20T05:00:00Z, "2023-04-20T05:00:00 TT"
  input,         // the name of a file that is read
  inputs,        // of several
  output,        // the name of a file that is written
  table,
  tables  // [[name]], any number
};

/// A key of a scenario file. The reader, its messages and the page of the reference come from these.
struct Key {
  std::string name;
  Kind kind;
  bool needed;
  std::string help;  // one line
  std::vector<std::string_view> choices{};
  Dimension dimension = Dimension::angle;  // of amounts
  std::size_t count = 0;                   // of numbers, texts and amounts; 0: any, at least one
  std::vector<Key> keys{};                 // of a table, or of each of several

  [[nodiscard]] const Key* find(std::string_view key) const;
};

inline constexpr int scenario_version = 1;

/// The whole file, as a table.
const Key& schema();
/// How a key is to be written: "a text with a unit (deg, rad, ...)".
std::string form_of(const Key& key);
/// Whether it is a table, or one of several.
bool is_section(const Key& key);
/// "[time]", "[[frame]]"
std::string name_of_section(const Key& key);
/// "Needed: the attitude that was flown."
std::string meaning_of_section(const Key& key);
/// What holds for all keys; names stand in `these`.
const std::vector<std::string>& schema_rules();
/// The page docs/reference/scenario_file.md.
std::string schema_page();

}  // namespace vectrix::cli
