#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// The part of a file that is asked for.
struct Selection {
  std::optional<std::size_t>
      segment{};  // of a message, counted from 1; it may be left out if there is only one
  std::optional<Epoch> from{}, until{};           // both included
  std::string segment_word = "--segment NUMBER";  // how to state it
};

/// The place of the first sample that is selected, and of the one after the last. Throws BadInput if they are
/// fewer than two.
struct Places {
  std::ptrdiff_t first, end;
};
Places selected(const std::vector<Epoch>& times, const Selection& selection, const std::string& file);

template <class Value> void keep(std::vector<Value>& values, const Places& places) {
  if (values.empty()) return;
  values.erase(values.begin() + places.end, values.end());
  values.erase(values.begin(), values.begin() + places.first);
}

/// The segment of a message. Throws BadInput if it is not there, or has to be named.
template <class Message>
const auto& segment_of(const Message& message, const Selection& selection,
                       const std::filesystem::path& file) {
  const auto& segment = selection.segment;
  const std::size_t count = message.segments().size();
  if (!segment && count > 1)
    throw BadInput(file.string() + ": there are " + detail::text(count) +
                   " segments; missing: " + selection.segment_word);
  if (segment && (*segment < 1 || *segment > count))
    throw BadInput(file.string() + ": asked for segment " + detail::text(*segment) + " of " +
                   detail::text(count));
  return message.segments()[segment.value_or(1) - 1];
}

/// EME2000 or GCRF, of the names EME2000, J2000, GCRF and ICRF in any capitals; nothing for another frame.
std::optional<std::string> inertial(const std::string& name);

}  // namespace vectrix::cli
