#pragma once

#include <string>
#include <vector>

#include "target.hpp"

namespace vectrix::cli {

/// While the Sun is seen or not, or the target is not hidden by the Earth.
enum class When { always, sunlight, shadow, visible };

/// "sunlight", "shadow", "visible"
std::vector<std::string> when_names();
When when_of(const std::string& name);
/// " in sunlight", " in shadow", " while it is visible", or nothing.
std::string words_of(When when);
/// Throws BadInput if it cannot be said: nothing hides the target, or there is no orbit, `missing`.
void require_known(When when, const MeasureTarget& target, bool has_orbit, const char* missing);

/// Which samples count; empty if all do. `hidden` as hidden_by_earth() has it, `visible_sun` as
/// visible_suns(). Throws BadInput if none does.
std::vector<bool> counting(When when, const std::vector<bool>& hidden, const std::vector<double>& visible_sun,
                           const std::string& target);
/// The values at those that count.
template <class Value>
std::vector<Value> counted_of(const std::vector<Value>& values, const std::vector<bool>& counts) {
  std::vector<Value> kept;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (counts.empty() || counts[i]) kept.push_back(values[i]);
  return kept;
}
/// What does not count: "60 of 181 samples are left out, the Earth hides the target"; "" if all do.
std::string words_of_left_out(When when, const std::vector<bool>& counts, const char* samples);

}  // namespace vectrix::cli
