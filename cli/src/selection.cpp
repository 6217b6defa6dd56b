#include "selection.hpp"

#include "table_text.hpp"

namespace vectrix::cli {

Places selected(const std::vector<Epoch>& times, const Selection& selection, const std::string& file) {
  const auto first =
      selection.from ? std::lower_bound(times.begin(), times.end(), *selection.from) : times.begin();
  const auto last =
      selection.until ? std::upper_bound(times.begin(), times.end(), *selection.until) : times.end();
  if (last - first < 2)
    throw BadInput(file + ": the samples from " + selection.from.value_or(times.front()).utc() +
                   " UTC until " + selection.until.value_or(times.back()).utc() + " UTC are " +
                   detail::text(std::max<std::ptrdiff_t>(last - first, 0)) + "; at least two are needed");
  return {first - times.begin(), last - times.begin()};
}

std::optional<std::string> inertial(const std::string& name) {
  const std::string known = small(name);
  if (known == "eme2000" || known == "j2000") return "EME2000";
  if (known == "gcrf" || known == "icrf") return "GCRF";
  return std::nullopt;
}

}  // namespace vectrix::cli
