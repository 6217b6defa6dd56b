#include "element_sets.hpp"

#include <algorithm>
#include <iterator>

#include "attitude_record.hpp"
#include "figures.hpp"
#include "message_kind.hpp"

namespace vectrix::cli {

std::vector<ElementSet> read_two_lines(const std::filesystem::path& file) {
  if (is_message(file))
    throw BadInput(
        file.string() +
        ": is a message of CCSDS, no two-line elements; an OMM is given by --omm, or by omm in [orbit]");
  std::vector<ElementSet> sets;
  for (const TwoLineElements& set : TwoLineElements::read(file))
    sets.push_back({set.mean_elements(), detail::text(set.catalogue_number()), set.designator()});
  return sets;
}

std::vector<ElementSet> read_mean_elements(const std::filesystem::path& file) {
  std::vector<ElementSet> sets;
  for (const OrbitMeanElementsMessage& message : read_mean_elements_messages(file)) {
    const auto& number = message.catalogue_number();
    sets.push_back(
        {message.mean_elements(), number ? detail::text(*number) : std::string{}, message.object_id()});
  }
  return sets;
}

std::vector<ElementSet> of_satellite(const std::vector<ElementSet>& sets, const std::filesystem::path& file,
                                     const StatedSatellite& satellite) {
  std::vector<std::string> names;
  for (const ElementSet& set : sets)
    if (std::find(names.begin(), names.end(), set.name()) == names.end()) names.push_back(set.name());
  if (names.size() == 1 && satellite.value.empty()) return sets;
  std::vector<ElementSet> found;
  std::copy_if(sets.begin(), sets.end(), std::back_inserter(found), [&](const ElementSet& set) {
    return !satellite.value.empty() && (set.number == satellite.value || set.designator == satellite.value);
  });
  if (!found.empty()) return found;
  constexpr std::size_t most_shown = 5;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), most_shown); ++i)
    list += (i == 0 ? "" : ", ") + names[i];
  if (names.size() > most_shown) list += ", ...";
  throw BadInput(file.string() + ": it has the elements of " + counted(names.size(), "satellite") + ", " +
                 list + "; " +
                 (satellite.value.empty()
                      ? "missing: " + satellite.word
                      : satellite.word.substr(0, satellite.word.find(' ')) + " is " + satellite.value));
}

}  // namespace vectrix::cli
