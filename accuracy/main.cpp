// accuracy: measures the error of every function against wider arithmetic, prints the table, and fails if an
// error exceeds its bound.
//     accuracy [--samples NUMBER] [--write FILE.md]

#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "heading.hpp"
#include "table.hpp"

namespace {

using namespace vectrix::accuracy;

struct Arguments {
  std::string samples = "20000";
  std::string write;
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    std::string* target = word == "--samples" ? &arguments.samples
                          : word == "--write" ? &arguments.write
                                              : nullptr;
    if (target == nullptr || i + 1 == count) {
      throw std::invalid_argument("usage: accuracy [--samples NUMBER] [--write FILE.md]");
    }
    *target = values[++i];
  }
  return arguments;
}

int run(const Arguments& arguments) {
  const long samples = std::stol(arguments.samples);
  if (samples < 1) throw std::invalid_argument("accuracy: the number of samples is " + arguments.samples);
  Table table(static_cast<std::size_t>(samples));
  for (const auto rows : {frame_rows, rotation_rows, quaternion_rows, parameter_rows, parameter_rate_rows,
                          euler_rows, euler_rate_rows, jacobian_rows, screw_rows, law_rows, step_rows,
                          sampled_rows, fit_rows, free_rotation_rows}) {
    rows(table);
  }
  const std::string page = heading + table.markdown();
  std::cout << page;
  if (!arguments.write.empty()) {
    std::ofstream file(arguments.write);
    if (!(file << page).flush()) throw std::runtime_error("accuracy: cannot write " + arguments.write);
  }
  std::size_t failed = 0;
  for (const Row& row : table.rows()) {
    if (row.passed()) continue;
    ++failed;
    std::cerr << "not kept: " << row.function << ", " << row.domain << ": " << row.largest << " ulp at "
              << row.worst << ", promised " << row.promise.ulps << "\n";
  }
  std::cout << "\n" << table.rows().size() - failed << " promises are kept, " << failed << " are not.\n";
  return failed == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** values) try {
  return run(parse(count, values));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
