#pragma once

#include <functional>
#include <string>
#include <vector>

#include "timing.hpp"

namespace bench {

using Numbers = std::vector<double>;

template <class Result> Numbers numbers(const Result& result) {
  const auto list = [](const auto& matrix) { return Numbers(matrix.data(), matrix.data() + matrix.size()); };
  if constexpr (requires { result.coeffs().data(); }) {
    return list(result.coeffs());
  } else if constexpr (requires { result.eigen(); }) {
    return list(result.eigen().coeffs());
  } else if constexpr (requires { result.matrix().data(); }) {
    return list(result.matrix());
  } else if constexpr (requires { result.coordinates(); }) {
    return list(result.coordinates());
  } else {
    return list(result);
  }
}

/// One form of a kernel.
struct Form {
  std::function<void(long)> repeat;
  std::function<Numbers()> result;
};
template <class Call> Form form(Call call) {
  return {[call](long calls) {
            for (long i = 0; i < calls; ++i) {
              alignas(64) const auto result = call();
              keep(result);
            }
          },
          [call] { return numbers(call()); }};
}

struct Kernel {
  std::string name;
  Form typed, raw;
};

/// The kernels with their operands; both forms use the same numbers.
std::vector<Kernel> kernels();

}  // namespace bench
