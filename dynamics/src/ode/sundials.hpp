#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.hpp>

namespace vectrix::ode {

struct FreeVector {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
using VectorPtr = std::unique_ptr<_generic_N_Vector, FreeVector>;

inline std::span<double> span_of(N_Vector vector) {
  return {N_VGetArrayPointer(vector), static_cast<std::size_t>(N_VGetLength(vector))};
}

inline VectorPtr make_vector(std::span<const double> values, SUNContext context) {
  VectorPtr vector(N_VNew_Serial(static_cast<sunindextype>(values.size()), context));
  if (!vector) throw std::bad_alloc();
  std::copy(values.begin(), values.end(), span_of(vector.get()).begin());
  return vector;
}

/// Error handler of SUNDIALS that keeps the text instead of printing it.
inline void keep_message(int code, const char*, const char*, char* text, void* message) {
  if (code < 0) *static_cast<std::string*>(message) = text;
}

/// Copies the name of a flag and frees the memory that SUNDIALS allocated for it.
inline std::string take_name(char* name) {
  const std::unique_ptr<char, decltype(&std::free)> owner(name, &std::free);
  return name == nullptr ? "unnamed" : name;
}

/// Set-up calls fail if memory runs out or by an error of this library, never because of the problem's data.
inline void require_success(int flag, const char* call) {
  if (flag < 0)
    throw std::runtime_error(std::string("ode: ") + call + " returned flag " + std::to_string(flag));
}

}  // namespace vectrix::ode
