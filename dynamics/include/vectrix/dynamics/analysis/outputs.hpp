#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/analysis/duals.hpp>
#include <vectrix/dynamics/analysis/inputs.hpp>
#include <vectrix/dynamics/craft/motion.hpp>

namespace vectrix {

/// A named function of a motion in any scalar. Made by output().
template <class F> struct CraftOutput {
  std::string name;
  F function;
};
/// What is measured: a function of const auto& motion, which is a CraftMotion<C, S>, that gives a number, a
/// quantity, or a vector of any kind:
///     output("gyro", [](const auto& motion) {
///       return motion.now().angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>); })
template <class F> CraftOutput<F> output(std::string name, F function) {
  return {std::move(name), std::move(function)};
}

template <class... F> struct CraftOutputs { std::tuple<CraftOutput<F>...> list; };
template <class... F> CraftOutputs<F...> outputs(CraftOutput<F>... output) {
  return {{std::move(output)...}};
}
template <class... Given> auto outputs(const Given&...) -> Refused = delete;  // outputs(output(name, f), ...)

// The mistakes in a list of outputs, for messages.
template <class F> struct GivesNoNumberOrVector {};

namespace detail {

template <class Value> constexpr std::size_t numbers_in() {
  if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, Dual> || is_quantity<Value>)
    return 1;
  else if constexpr (requires(const Value& value) { value.coordinates(); })
    return 3;
  else
    return 0;
}
template <class Value> const char* unit_of_value() {
  if constexpr (requires { typename Value::unit; })
    return unit_symbol<typename Value::unit>;
  else if constexpr (requires(const Value& value) { value.vector(); })
    return unit_of_value<std::remove_cvref_t<decltype(std::declval<const Value&>().vector())>>();
  else
    return "";
}
template <class Value> void append_numbers(const Value& value, std::vector<Dual>& list) {
  if constexpr (is_quantity<Value>) {
    list.push_back(value.value());
  } else if constexpr (numbers_in<Value>() == 1) {
    list.push_back(value);
  } else {
    for (Eigen::Index i = 0; i < 3; ++i) list.push_back(value.coordinates()[i]);
  }
}
template <class Value> std::vector<std::string> names_of_output(const std::string& name) {
  const char* unit = unit_of_value<Value>();
  if constexpr (numbers_in<Value>() == 3)
    return names_of_three(name, unit);
  else
    return {name + (*unit == '\0' ? std::string{} : std::string{" ["} + unit + "]")};
}

template <class C, class F>
using OutputValue = std::remove_cvref_t<std::invoke_result_t<const F&, const CraftMotion<C, Dual>&>>;
template <class C, class F> constexpr bool is_output() {
  if constexpr (std::invocable<const F&, const CraftMotion<C, Dual>&>)
    return numbers_in<OutputValue<C, F>>() > 0;
  else
    return false;
}
template <class C, class... F> constexpr auto fault_of_outputs() {
  constexpr std::size_t bad = first_of<!is_output<C, F>()...>();
  if constexpr (bad != nowhere)
    return std::type_identity<GivesNoNumberOrVector<std::tuple_element_t<bad, std::tuple<F...>>>>{};
  else
    return std::type_identity<Nothing>{};
}

}  // namespace detail
}  // namespace vectrix
