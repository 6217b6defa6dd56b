#include <vectrix/space/files/leap_second_kernel.hpp>

#include <cmath>

#include <erfa.h>
#include <erfam.h>

#include <vectrix/frames/errors.hpp>

#include "../time/date.hpp"
#include "ephemeris_time.hpp"

namespace vectrix {
namespace {

void require_constants(const TextKernel& kernel) {
  const auto& c = detail::ephemeris_time_constants;
  const auto require = [&](const char* name, const std::vector<double>& known) {
    if (const auto found = kernel.numbers(name); found != known)
      kernel.refuse(name, "is " + detail::text(found.front()) + " and not " + detail::text(known.front()));
  };
  require("DELTET/DELTA_T_A", {c.delta_t_a});
  require("DELTET/K", {c.k});
  require("DELTET/EB", {c.eb});
  require("DELTET/M", {c.m0, c.m1});
}

}  // namespace

std::vector<LeapSecond> leap_seconds_of(const TextKernel& kernel) {
  require_constants(kernel);
  constexpr const char* name = "DELTET/DELTA_AT";
  const auto& values = kernel.variable(name).values;
  if (values.size() % 2 != 0)
    kernel.refuse(name, "has " + detail::text(values.size()) + " values, which are no pairs");
  std::vector<LeapSecond> table;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const TextKernel::Value &seconds = values[i], &date = values[i + 1];
    constexpr double most = 1000.0;
    if (seconds.kind != TextKernel::Value::Kind::number || seconds.number != std::floor(seconds.number) ||
        !(std::abs(seconds.number) <= most))
      kernel.refuse(seconds, "a whole number of seconds is expected");
    const double days = date.kind == TextKernel::Value::Kind::date ? kernel.seconds(date) / ERFA_DAYSEC : 0.0;
    if (days - 0.5 != std::floor(days - 0.5)) kernel.refuse(date, "the date of a midnight is expected");
    const auto first = detail::calendar_of(ERFA_DJ00 + days);
    if (first.day != 1) kernel.refuse(date, "'" + date.text + "' is not the first of a month");
    table.push_back({first.year, first.month, static_cast<int>(seconds.number)});
  }
  return table;
}

std::vector<LeapSecond> read_leap_second_kernel(const std::filesystem::path& file) {
  return leap_seconds_of(TextKernel::read(file));
}

}  // namespace vectrix
