#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vectrix::cli {

/// What a dataset of a result holds.
enum class Hdf5Kind { numbers, whole_numbers, texts };

/// A dataset or a group of a result. Writer, reader and the page of the reference take it from here.
struct Hdf5Entry {
  std::string_view path;  // N stands for 1, 2, ...
  Hdf5Kind kind;
  std::string_view rows;     // one for each: "instant"
  std::size_t columns;       // 0: any number
  std::string_view unit;     // of numbers
  std::string_view meaning;  // one line
  std::string_view words;    // its other attributes
};

/// Those of When, in its order.
inline constexpr std::array<std::string_view, 4> when_words{"always", "sunlight", "shadow", "visible"};

/// The number in the attribute `form`. A file with another one is refused.
inline constexpr int result_form = 1;

const std::vector<Hdf5Entry>& result_entries();
/// The entry of a path, which has numbers where the entry has N.
const Hdf5Entry& result_entry(const std::string& path);
/// The page docs/reference/result_file.md.
std::string result_page();

}  // namespace vectrix::cli
