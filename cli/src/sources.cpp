#include "sources.hpp"

#include <utility>

#include "stored_attitude.hpp"

namespace vectrix::cli {

AttitudeRecord read_attitude(const AttitudeSource& source) {
  AttitudeRecord record = source.kernel    ? read_kernel(source.file, *source.kernel, source.selection)
                          : source.columns ? read_table(source.file, *source.columns)
                          : is_stored_result(source.file) ? read_stored_attitude(source.file)
                                                          : read_message(source.file, source.selection);
  const Places places = selected(record.times, source.selection, record.file);
  keep(record.times, places);
  keep(record.numbers, places);
  keep(record.rates, places);
  keep(record.derived_rates, places);
  return record;
}

std::vector<std::filesystem::path> files_of(const AttitudeSource& source) {
  std::vector<std::filesystem::path> files{source.file};
  if (source.kernel)
    for (const std::string& file : {source.kernel->clock, source.kernel->frames, source.kernel->leap_seconds})
      if (!file.empty()) files.emplace_back(file);
  return files;
}

std::vector<std::filesystem::path> files_of(const OrbitSource& source) {
  std::vector<std::filesystem::path> files{source.elements, source.mean_elements, source.message,
                                           source.kernel};
  if (source.table) files.push_back(source.table->file);
  std::erase(files, std::filesystem::path());
  return files;
}

FlownOrbit read_orbit(const OrbitSource& source, const TimeSpan& span,
                      const std::optional<Epoch>& nearest_to) {
  std::string given;
  int count = 0;
  for (const auto& [option, file] : {std::pair{"--tle ", &source.elements},
                                     {"--omm ", &source.mean_elements},
                                     {"--oem ", &source.message},
                                     {"--spk ", &source.kernel}}) {
    if (file->empty()) continue;
    given += (given.empty() ? "" : " and ") + std::string(option) + file->string();
    ++count;
  }
  if (count > 1) throw BadInput("two orbits are given, " + given);
  if (!source.kernel.empty()) return orbit_of_kernel(source.kernel, span);
  const auto of_sets = [&](const auto& read, const std::filesystem::path& file) {
    return orbit_of_elements(read(file), file, span, nearest_to, source.satellite);
  };
  if (!source.elements.empty()) return of_sets(read_two_lines, source.elements);
  if (!source.mean_elements.empty()) return of_sets(read_mean_elements, source.mean_elements);
  if (!source.message.empty())
    return orbit_of_message(source.message, span, source.interpolation, source.orientation);
  if (source.table)
    return orbit_of_table(*source.table, span, *source.interpolation.value, source.orientation);
  return nullptr;
}

}  // namespace vectrix::cli
