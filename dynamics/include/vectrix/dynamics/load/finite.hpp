#pragma once

#include <cmath>
#include <string>
#include <vectrix/dynamics/force/wrench.hpp>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/print.hpp>
#include <vectrix/frames/quantity.hpp>

namespace vectrix::detail {

inline bool all_finite(double number) {
  return std::isfinite(number);
}
template <class U> bool all_finite(const Quantity<U>& x) {
  return std::isfinite(x.value());
}
template <class Framed>
  requires requires(const Framed& v) {
    v.coordinates();
  }
bool all_finite(const Framed& v) {
  return v.coordinates().allFinite();
}
template <class P, class D> bool all_finite(const Wrench<P, D>& W) {
  return all_finite(W.force()) && all_finite(W.torque());
}

/// A load, for a message that may be needed: "friction on Panel". The text is made with the message.
struct LoadName {
  const char* load;
  NameFunction on = nullptr;

  LoadName(const char* what) : load(what) {}
  LoadName(const char* what, NameFunction frame) : load(what), on(frame) {}
  VECTRIX_EXPORT std::string text() const;
};

/// For two numbers that may differ in their last digits only.
template <class U> std::string all_digits(const Quantity<U>& x) {
  return text(x.value()) + " " + unit_symbol<U>;
}
// Throws BadInput: load: the what is value, and the rule.
[[noreturn]] VECTRIX_EXPORT void refuse_value(const LoadName& load, const char* what,
                                              const std::string& value, const char* rule = "");
[[noreturn]] VECTRIX_EXPORT void refuse_value(const LoadName& load, const char* what, double value,
                                              const char* unit, const char* rule = "");

/// The value itself. Throws BadInput, as "spring on Panel: the stiffness is nan", if it is not finite.
template <class Value> const Value& finite(const LoadName& load, const char* what, const Value& value) {
  if (!all_finite(value)) refuse_value(load, what, text(value));
  return value;
}
template <class U> const Quantity<U>& finite(const LoadName& load, const char* what, const Quantity<U>& x) {
  if (!all_finite(x)) refuse_value(load, what, x.value(), unit_symbol<U>);
  return x;
}
/// Also if it is negative.
template <class U>
const Quantity<U>& not_negative(const LoadName& load, const char* what, const Quantity<U>& x) {
  if (!(finite(load, what, x).value() >= 0.0))
    refuse_value(load, what, x.value(), unit_symbol<U>, "; it must not be negative");
  return x;
}
/// Also if it is not greater than 0.
template <class U> const Quantity<U>& positive(const LoadName& load, const char* what, const Quantity<U>& x) {
  if (!(finite(load, what, x).value() > 0.0))
    refuse_value(load, what, x.value(), unit_symbol<U>, "; it must be positive");
  return x;
}

}  // namespace vectrix::detail
