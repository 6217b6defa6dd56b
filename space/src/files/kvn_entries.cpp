#include "kvn_entries.hpp"

#include <charconv>

#include <vectrix/frames/errors.hpp>

#include "shifted_number.hpp"
#include "text_file.hpp"

namespace vectrix::detail {

void KvnEntries::add(KvnLine line) {
  const auto [entry, is_new] = lines_.try_emplace(line.keyword, line);
  if (!is_new) fail(line, "the keyword is there for the second time, after line " + text(entry->second.line));
}

const KvnLine* KvnEntries::find(std::string_view keyword) const {
  const auto found = lines_.find(keyword);
  return found == lines_.end() ? nullptr : &found->second;
}

const KvnLine& KvnEntries::line(std::string_view keyword) const {
  if (const KvnLine* found = find(keyword)) return *found;
  throw BadInput(place_ + ", " + what_ + ": there is no " + std::string{keyword});
}

const KvnLine& KvnEntries::filled(std::string_view keyword) const {
  const KvnLine& found = line(keyword);
  if (found.value.empty()) fail(found, "it is empty");
  return found;
}

double KvnEntries::number(const KvnLine& line, std::string_view unit, int shift) const {
  std::string_view written = line.value;
  if (const auto bracket = written.find('['); bracket != std::string_view::npos) {
    if (unit.empty() ||
        upper_case(std::string{written.substr(bracket)}) != upper_case("[" + std::string{unit} + "]"))
      fail(line, unit.empty() ? "it has no unit" : "the unit is [" + std::string{unit} + "]");
    written = trimmed(written.substr(0, bracket));
  }
  const auto value = parse_shifted(written, shift);
  if (!value) fail(line, number_fault(written, shift));
  return *value;
}

std::int64_t KvnEntries::whole(const KvnLine& line) const {
  std::int64_t value = 0;
  const char *begin = line.value.data(), *end = begin + line.value.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || value < 0) fail(line, "not a whole number");
  return value;
}

Epoch KvnEntries::epoch(const KvnLine& line, const TimeScale& scale) const {
  EpochReader reader(scale);
  return epoch_of(reader, line.value, [&](const std::string& reason) { fail(line, reason); });
}

}  // namespace vectrix::detail
