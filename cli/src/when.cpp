#include "when.hpp"

#include <algorithm>
#include <array>

#include "figures.hpp"
#include "hidden.hpp"

namespace vectrix::cli {
namespace {

constexpr std::array names{"sunlight", "shadow", "visible"};

}  // namespace

std::vector<std::string> when_names() {
  return {names.begin(), names.end()};
}

When when_of(const std::string& name) {
  const auto place = std::find(names.begin(), names.end(), name) - names.begin();
  return static_cast<When>(place + 1);
}

std::string words_of(When when) {
  switch (when) {
    case When::always:
      return "";
    case When::visible:
      return " while it is visible";
    default:
      return when == When::sunlight ? " in sunlight" : " in shadow";
  }
}

void require_known(When when, const MeasureTarget& target, bool has_orbit, const char* missing) {
  if (when == When::always) return;
  if (when == When::visible && !may_be_hidden(target))
    throw BadInput("the Earth hides the Sun, the Moon, stars and stations, and not " + name_of(target));
  if (!has_orbit)
    throw BadInput("whether it is " +
                   std::string(when == When::visible ? "visible" : words_of(when).substr(1)) +
                   " needs an orbit; missing: " + missing);
}

std::vector<bool> counting(When when, const std::vector<bool>& hidden, const std::vector<double>& visible_sun,
                           const std::string& target) {
  std::vector<bool> all;
  if (when == When::always) return all;
  if (when == When::visible) {
    all = hidden;
    all.flip();
  } else {
    for (const double part : visible_sun) all.push_back(part == (when == When::sunlight ? 1.0 : 0.0));
  }
  if (std::find(all.begin(), all.end(), true) == all.end())
    throw BadInput(when == When::visible ? "at no instant is " + target + " visible past the Earth"
                                         : "no instant is" + words_of(when));
  return all;
}

std::string words_of_left_out(When when, const std::vector<bool>& counts, const char* samples) {
  const auto count = std::count(counts.begin(), counts.end(), false);
  if (count == 0) return "";
  return std::to_string(count) + " of " + counted(counts.size(), samples) + (count == 1 ? " is" : " are") +
         " left out, " +
         (when == When::visible ? "where the Earth hides the target" : "which are not" + words_of(when));
}

}  // namespace vectrix::cli
