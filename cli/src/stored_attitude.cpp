#include "stored_attitude.hpp"

#include <fstream>
#include <string_view>

#include "result_file/result_file.hpp"

namespace vectrix::cli {

bool is_stored_result(const std::filesystem::path& file) {
  constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
  std::ifstream in(file, std::ios::binary);
  if (!in) throw BadInput(file.string() + ": cannot be read");
  std::string start(signature.size(), ' ');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == signature;
}

AttitudeRecord read_stored_attitude(const std::filesystem::path& file) {
  Result result = read_result(file);
  AttitudeRecord record;
  record.file = file.string();
  record.body = result.body;
  record.names_body = true;
  record.reference = result.reference;
  record.stated = {Convention::Scalar::first, Convention::Maps::to_reference};
  record.times = std::move(result.samples.times);
  for (const auto& q : result.samples.reference_from_body)
    record.numbers.push_back({q.w(), q.x(), q.y(), q.z()});
  record.rates = std::move(result.samples.rates);
  record.longest_step = result.samples.longest_step;
  return record;
}

}  // namespace vectrix::cli
