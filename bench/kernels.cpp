/// Runs each kernel in both forms, typed and raw Eigen, and prints one line per form:
///     kernels count    under callgrind, which counts the instructions of one call
///     kernels time     paired time, allocations, and whether both forms give the same numbers
#include <valgrind/callgrind.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vectrix/frames/scalar/larger.hpp>

#include "kernel.hpp"
#include "testing/allocations.hpp"

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr long counted_calls = 100;
constexpr std::size_t rounds = 2001;
constexpr double round_ns = 20'000.0;
constexpr double same = 1e-14;  // the same mathematics in both forms: rounding only

double seconds(const Form& form, long calls) {
  const auto start = Clock::now();
  form.repeat(calls);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void count(const Kernel& kernel) {
  for (const auto& [name, form] : {std::pair{"typed", &kernel.typed}, std::pair{"raw", &kernel.raw}}) {
    const std::string label = std::string{name} + "\t" + kernel.name;
    form->repeat(1);  // the first call also runs the dynamic linker
    CALLGRIND_ZERO_STATS;
    form->repeat(counted_calls);
    CALLGRIND_DUMP_STATS_AT(label.c_str());
  }
}

/// Rounds of one batch of each form, in random order, so that a slow machine slows both forms.
bool time(const Kernel& kernel) {
  const Numbers typed = kernel.typed.result();
  const Numbers raw = kernel.raw.result();
  double difference = 0.0;
  for (std::size_t i = 0; i < raw.size(); ++i)
    difference = vectrix::detail::larger(difference, std::abs(typed.at(i) - raw[i]));

  constexpr long probe = 1000;
  seconds(kernel.raw, probe);
  const long calls = 1 + static_cast<long>(round_ns / (1e9 * seconds(kernel.raw, probe) / probe));
  std::mt19937 generator(20240229);
  std::vector<double> ratios(rounds), raw_ns(rounds);
  const std::size_t before = vectrix_test::allocations();
  for (std::size_t i = 0; i < rounds; ++i) {
    const bool typed_first = generator() % 2 == 0;
    const double first = seconds(typed_first ? kernel.typed : kernel.raw, calls);
    const double second = seconds(typed_first ? kernel.raw : kernel.typed, calls);
    ratios[i] = typed_first ? first / second : second / first;
    raw_ns[i] = 1e9 * (typed_first ? second : first) / static_cast<double>(calls);
  }
  const std::size_t allocated = vectrix_test::allocations() - before;
  std::printf("%s\t%.2f\t%.3f\t%zu\n", kernel.name.c_str(), median(raw_ns), median(ratios), allocated);
  if (difference <= same) return true;
  std::fprintf(stderr, "kernels: %s: typed and raw differ by %g\n", kernel.name.c_str(), difference);
  return false;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what != "count" && what != "time") {
    std::fprintf(stderr, "kernels count|time\n");
    return 2;
  }
  bool agree = true;
  for (const bench::Kernel& kernel : bench::kernels()) {
    if (what == "count") {
      bench::count(kernel);
    } else {
      agree = bench::time(kernel) && agree;
    }
  }
  return agree ? 0 : 1;
}
