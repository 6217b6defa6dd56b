#include "scenario/one_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include "scenario/schema.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

namespace fs = std::filesystem;

// Whatever the library says of it, "integer" is no word of this program.
std::string name_of(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (node.is_array()) return "an array";
  if (node.is_string()) return "a text";
  if (node.is_boolean()) return "true or false";
  if (node.is_number()) return "a number";
  return "a date or a time";
}

// One file.
class FileReader {
 public:
  explicit FileReader(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] ScenarioTable table(const toml::table& from, const Key& key, const std::string& path) const {
    ScenarioTable table{place(from), path};
    for (const auto& [name, node] : from) {
      const std::string text(name.str());
      const Key* const known = key.find(text);
      if (!known)
        refuse(place(name.source()), "unknown key '" + text + "'" + of_table(path) + unknown(key, text));
      const std::string longer = path.empty() ? text : path + '.' + text;
      table.values.emplace(text, value(node, *known, longer));
    }
    return table;
  }

 private:
  [[nodiscard]] Place place(const toml::source_region& region) const {
    return {file_, std::max<std::size_t>(region.begin.line, 1),
            std::max<std::size_t>(region.begin.column, 1)};
  }
  [[nodiscard]] Place place(const toml::node& node) const { return place(node.source()); }
  // Of a character of a text. One with escapes, or of several lines, is only known from its beginning.
  [[nodiscard]] Place place(const toml::node& node, const std::string& text, std::size_t at) const {
    Place found = place(node);
    const auto& region = node.source();
    constexpr std::size_t quotes = 2;
    if (region.begin.line == region.end.line &&
        region.end.column - region.begin.column == text.size() + quotes)
      found.column += 1 + at;
    return found;
  }

  static std::string of_table(const std::string& path) { return path.empty() ? "" : " of '" + path + "'"; }
  static std::string unknown(const Key& key, const std::string& text) {
    std::vector<std::string_view> names;
    for (const Key& each : key.keys) names.push_back(each.name);
    return instead_of(text, names);
  }

  [[noreturn]] void refuse_kind(const toml::node& node, const Key& key, const std::string& path) const {
    refuse(place(node), "'" + path + "' is " + name_of(node) + "; needed: " + form_of(key));
  }

  [[nodiscard]] ScenarioValue value(const toml::node& node, const Key& key, const std::string& path) const {
    ScenarioValue made{place(node), std::string{}, path};
    switch (key.kind) {
      case Kind::text:
        made.value = text(node, key, path);
        break;
      case Kind::name:
        made.value = name(node, key, path);
        break;
      case Kind::whole_number:
        made.value = whole_number(node, key, path);
        break;
      case Kind::choice:
        made.value = choice(node, key, path);
        break;
      case Kind::numbers:
        made.value = numbers(node, key, path);
        break;
      case Kind::rows:
        made.value = rows(node, key, path);
        break;
      case Kind::texts:
        made.value = texts(node, key, path);
        break;
      case Kind::inputs:
        made.value = inputs(node, key, path);
        break;
      case Kind::amount:
      case Kind::amounts:
        made.value = amount(node, key, path);
        break;
      case Kind::axis:
        made.value = text(node, key, path);
        made.place = place(node, made.text(), 0);
        break;
      case Kind::epoch:
        made.value = epoch(node, key, path);
        break;
      case Kind::input:
        made.value = input(node, text(node, key, path));
        break;
      case Kind::output:
        made.value = text(node, key, path);
        break;
      case Kind::table:
        if (!node.is_table()) refuse_kind(node, key, path);
        made.value = std::vector{table(*node.as_table(), key, path)};
        break;
      case Kind::tables:
        made.value = tables(node, key, path);
        break;
    }
    return made;
  }

  [[nodiscard]] std::string text(const toml::node& node, const Key& key, const std::string& path) const {
    const auto* const found = node.as_string();
    if (!found) refuse_kind(node, key, path);
    std::string text = found->get();
    if (text.empty()) refuse(place(node), "'" + path + "' is empty");
    if (text.find_first_not_of(' ') == std::string::npos) refuse(place(node), "'" + path + "' is blank");
    if (const auto control =
            std::find_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
        control != text.end())
      refuse(place(node), "'" + path + "' holds a line break or another control character");
    return text;
  }
  [[nodiscard]] std::string name(const toml::node& node, const Key& key, const std::string& path) const {
    std::string name = text(node, key, path);
    if (const auto at = name.find_first_of(",\"'"); at != std::string::npos)
      refuse(place(node, name, at), "'" + path + "' holds a comma or a quotation mark");
    return name;
  }
  [[nodiscard]] std::size_t whole_number(const toml::node& node, const Key& key,
                                         const std::string& path) const {
    const auto* const found = node.as_integer();
    if (!found) refuse_kind(node, key, path);
    if (found->get() < 1)
      refuse(place(node), "'" + path + "' is " + std::to_string(found->get()) + "; needed: " + form_of(key));
    return static_cast<std::size_t>(found->get());
  }
  [[nodiscard]] std::string choice(const toml::node& node, const Key& key, const std::string& path) const {
    const std::string wanted = text(node, key, path);
    for (const std::string_view each : key.choices)
      if (small(std::string(each)) == small(wanted)) return std::string(each);
    refuse(place(node), "'" + path + "' is '" + wanted + "'" + instead_of(wanted, key.choices) +
                            "; needed: " + form_of(key));
  }

  [[nodiscard]] const toml::array& array(const toml::node& node, const Key& key, const std::string& path,
                                         std::size_t count) const {
    const auto* const found = node.as_array();
    if (!found || found->empty() || (count != 0 && found->size() != count))
      refuse(place(node), "'" + path + "' is " +
                              (found ? "an array of " + std::to_string(found->size()) : name_of(node)) +
                              "; needed: " + form_of(key));
    return *found;
  }
  [[nodiscard]] std::vector<double> numbers(const toml::node& node, const Key& key,
                                            const std::string& path) const {
    std::vector<double> all;
    for (const toml::node& each : array(node, key, path, key.count)) {
      const auto number = each.is_number() ? each.value<double>() : std::nullopt;
      if (!number) refuse_kind(each, key, path);
      if (!std::isfinite(*number))
        refuse(place(each), "'" + path + "' holds " + detail::text(*number) + ", which is not finite");
      all.push_back(*number);
    }
    return all;
  }
  [[nodiscard]] std::vector<double> rows(const toml::node& node, const Key& key,
                                         const std::string& path) const {
    std::vector<double> all;
    for (const toml::node& row : array(node, key, path, key.count))
      for (const double number : numbers(row, key, path)) all.push_back(number);
    return all;
  }
  [[nodiscard]] std::vector<std::string> texts(const toml::node& node, const Key& key,
                                               const std::string& path) const {
    std::vector<std::string> all;
    for (const toml::node& each : array(node, key, path, key.count)) all.push_back(text(each, key, path));
    return all;
  }
  [[nodiscard]] std::vector<std::string> inputs(const toml::node& node, const Key& key,
                                                const std::string& path) const {
    std::vector<std::string> all;
    for (const toml::node& each : array(node, key, path, key.count))
      all.push_back(input(each, text(each, key, path)));
    return all;
  }

  [[nodiscard]] Amount amount(const toml::node& node, const Key& key, const std::string& path) const {
    if (node.is_number()) {
      const auto names = units_of(key.dimension);
      refuse(place(node), "'" + path + "' has no unit; " + cli::name_of(key.dimension) +
                              " is a text with one of: " + listed(names) + ", as \"1 " +
                              std::string(names.front()) + "\"");
    }
    const std::string written = text(node, key, path);
    try {
      return Amount::parse(written, key.dimension, key.count);
    } catch (const AmountError& error) {
      refuse(place(node, written, error.at()), "'" + path + "' is '" + written + "': " + error.what());
    }
  }

  [[nodiscard]] Epoch epoch(const toml::node& node, const Key& key, const std::string& path) const {
    try {
      if (const auto* const date = node.as_date_time()) return of_date(node, date->get(), path);
      return Epoch::from(text(node, key, path));
    } catch (const BadInput& error) {
      const std::string said = error.what();
      if (said.starts_with(file_ + ':')) throw;
      refuse(place(node), "'" + path + "': " + said);
    }
  }
  [[nodiscard]] Epoch of_date(const toml::node& node, const toml::date_time& given,
                              const std::string& path) const {
    if (!given.offset)
      refuse(place(node),
             "'" + path +
                 "' does not say its time scale; write it in UTC with a Z at its end, or as a text: "
                 "\"2023-04-20T05:00:00 TT\"");
    if (given.offset->minutes != 0)
      refuse(place(node), "'" + path + "' is " + std::to_string(given.offset->minutes) +
                              " minutes from UTC; write it in UTC with a Z at its end");
    char text[48];
    std::snprintf(text, sizeof text, "%04u-%02u-%02uT%02u:%02u:%02u.%09u", unsigned{given.date.year},
                  unsigned{given.date.month}, unsigned{given.date.day}, unsigned{given.time.hour},
                  unsigned{given.time.minute}, unsigned{given.time.second}, given.time.nanosecond);
    return Epoch::from_utc(text);
  }

  [[nodiscard]] std::string input(const toml::node& node, const std::string& named) const {
    const fs::path path = (fs::path(file_).parent_path() / named).lexically_normal();
    std::error_code none;  // of what does not exist
    if (!fs::exists(path, none))
      refuse(place(node),
             "there is no file " + path.string() + "; names are relative to the folder of this file");
    if (!fs::is_regular_file(path, none)) refuse(place(node), path.string() + " is no file");
    return path.string();
  }

  [[nodiscard]] std::vector<ScenarioTable> tables(const toml::node& node, const Key& key,
                                                  const std::string& path) const {
    const auto* const found = node.as_array();
    std::vector<ScenarioTable> all;
    if (!found)
      refuse(place(node), "'" + path + "' is " + name_of(node) + "; write [[" + path + "]], once for each");
    for (const toml::node& each : *found) {
      if (!each.is_table())
        refuse(place(each), "'" + path + "' holds " + name_of(each) + "; write [[" + path + "]]");
      all.push_back(table(*each.as_table(), key, path));
    }
    return all;
  }

  std::string file_;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code none;  // of what does not exist
  if (!in || fs::is_directory(file, none)) throw BadInput(file.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

ScenarioTable read_one_file(const std::filesystem::path& file) {
  try {
    return FileReader(file.string()).table(toml::parse(text_of(file), file.string()), schema(), "");
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    refuse({file.string(), at.line, at.column}, std::string(error.description()));
  }
}

}  // namespace vectrix::cli
