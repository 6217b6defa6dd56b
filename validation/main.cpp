// validate: compares Vectrix with every reference in the table, prints the table, and fails if a row fails.
//     validate [--data DIRECTORY] [--write FILE.md]

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "comparison.hpp"

namespace {

using namespace vectrix::validation;

constexpr const char* heading =
    "# Validation\n\n"
    "`./dev validate` writes this page. Each row compares a run of Vectrix, at its tightest tolerances, with "
    "a result that\nis not ours, with what a law keeps, or a rotor with the same wheel on a hinge. *Reached* "
    "is the largest difference over the whole run; of trees of bodies, "
    "over all crafts, each at one state. "
    "`validation/data/README.md` lists the sources.\n\n"
    "In the last table *reached* is a ratio: the difference with Simbody's accuracy tightened a hundred "
    "times, "
    "divided by the\ndifference before. A small ratio shows that the difference comes from Simbody.\n";

struct Arguments {
  std::string data = VECTRIX_VALIDATION_DATA;
  std::string write;
};

Arguments parse(int count, char** values) {
  Arguments arguments;
  for (int i = 1; i < count; ++i) {
    const std::string word = values[i];
    std::string* target = word == "--data" ? &arguments.data : word == "--write" ? &arguments.write : nullptr;
    if (target == nullptr || i + 1 == count) {
      throw std::invalid_argument("usage: validate [--data DIRECTORY] [--write FILE.md]");
    }
    *target = values[++i];
  }
  return arguments;
}

int run(const Arguments& arguments) {
  Rows rows;
  for (const auto source : {exact_rows, closed_form_rows, nasa_rows, basilisk_rows, erfa_rows, space_rows,
                            multibody_rows, prescribed_rows, simbody_rows, trees_in_motion_rows}) {
    const Rows more = source(arguments.data);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  const std::string page = heading + markdown(rows);
  std::cout << page;
  if (!arguments.write.empty()) {
    std::ofstream file(arguments.write);
    if (!(file << page).flush()) throw std::runtime_error("validate: cannot write " + arguments.write);
  }
  std::size_t failed = 0;
  for (const Row& row : rows) failed += row.passed() ? 0U : 1U;
  std::cout << "\n" << rows.size() - failed << " rows agree, " << failed << " do not.\n";
  return failed == 0 && !rows.empty() ? 0 : 1;
}

}  // namespace

int main(int count, char** values) try {
  return run(parse(count, values));
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
