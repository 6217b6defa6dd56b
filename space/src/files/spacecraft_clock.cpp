#include <vectrix/space/files/spacecraft_clock.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/trusted.hpp>

#include "../time/date.hpp"
#include "ephemeris_time.hpp"
#include "text_file.hpp"

namespace vectrix {

/// From `ticks` on the clock runs evenly.
struct ClockPiece {
  double ticks, time, seconds_per_tick;
};
/// Counts from start to end, which follow `before` ticks of other partitions.
struct ClockPartition {
  double start, end, before;
};
struct detail::ClockNumbers {
  std::string place;
  std::int32_t id = 0;
  bool is_tdb = true;
  char delimiter = '.';
  std::vector<double> moduli{}, offsets{}, units{};  // of each field, its unit in ticks
  std::vector<ClockPartition> partitions{};
  std::vector<ClockPiece> pieces{};

  [[nodiscard]] double end() const {
    return partitions.back().before + (partitions.back().end - partitions.back().start);
  }
  /// The last piece that begins before the count, or the first one.
  [[nodiscard]] const ClockPiece& piece_of(double count) const {
    const auto next = std::upper_bound(pieces.begin() + 1, pieces.end(), count,
                                       [](double c, const ClockPiece& piece) { return c < piece.ticks; });
    return *std::prev(next);
  }
};

namespace {

constexpr std::string_view clock_separators = ".:-, ";

void read_fields(const TextKernel& kernel, const std::string& end, detail::ClockNumbers& clock) {
  const auto name = [&](const char* begin) { return begin + end; };
  const std::int32_t count = kernel.integer(name("SCLK01_N_FIELDS_"));
  constexpr std::int32_t most = 10;
  if (count < 1 || count > most)
    kernel.refuse(name("SCLK01_N_FIELDS_"), "is " + detail::text(count) + "; a clock has 1 to 10 fields");
  const auto fields = static_cast<std::size_t>(count);
  clock.moduli = kernel.numbers(name("SCLK01_MODULI_"));
  clock.offsets = kernel.numbers(name("SCLK01_OFFSETS_"));
  for (const auto& [all, what] :
       {std::pair{&clock.moduli, "SCLK01_MODULI_"}, {&clock.offsets, "SCLK01_OFFSETS_"}}) {
    if (all->size() != fields)
      kernel.refuse(name(what),
                    "has " + detail::text(all->size()) + " numbers for " + detail::text(fields) + " fields");
    const double least = all == &clock.moduli ? 1.0 : 0.0;
    constexpr double largest = 9007199254740992.0;  // 2^53
    for (const double number : *all) {
      if (!(number >= least && number <= largest) || number != std::floor(number))
        kernel.refuse(name(what), "has the number " + detail::text(number));
    }
  }
  clock.units.assign(fields, 1.0);
  for (std::size_t i = fields - 1; i > 0; --i) clock.units[i - 1] = clock.units[i] * clock.moduli[i];
  if (kernel.find(name("SCLK01_OUTPUT_DELIM_"))) {
    const std::int32_t delimiter = kernel.integer(name("SCLK01_OUTPUT_DELIM_"));
    if (delimiter < 1 || delimiter > static_cast<std::int32_t>(clock_separators.size()))
      kernel.refuse(name("SCLK01_OUTPUT_DELIM_"), "is " + detail::text(delimiter) + "; it is 1 to 5");
    clock.delimiter = clock_separators[static_cast<std::size_t>(delimiter - 1)];
  }
}

void read_partitions(const TextKernel& kernel, const std::string& end, detail::ClockNumbers& clock) {
  const std::string starts_name = "SCLK_PARTITION_START_" + end, ends_name = "SCLK_PARTITION_END_" + end;
  const auto starts = kernel.numbers(starts_name), ends = kernel.numbers(ends_name);
  if (starts.size() != ends.size())
    kernel.refuse(ends_name, "has " + detail::text(ends.size()) + " numbers for " +
                                 detail::text(starts.size()) + " partitions");
  double before = 0.0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!(starts[i] >= 0.0 && ends[i] > starts[i]))
      kernel.refuse(ends_name, "says that partition " + detail::text(i + 1) + " goes from " +
                                   detail::text(starts[i]) + " to " + detail::text(ends[i]));
    clock.partitions.push_back({starts[i], ends[i], before});
    before += ends[i] - starts[i];
  }
}

void read_pieces(const TextKernel& kernel, const std::string& end, detail::ClockNumbers& clock) {
  const std::string name = "SCLK01_COEFFICIENTS_" + end;
  const auto& values = kernel.variable(name).values;
  if (values.size() % 3 != 0)
    kernel.refuse(name, "has " + detail::text(values.size()) + " values, which are no triples");
  for (std::size_t i = 0; i < values.size(); i += 3) {
    const ClockPiece piece{kernel.seconds(values[i]), kernel.seconds(values[i + 1]),
                           kernel.seconds(values[i + 2]) / clock.units.front()};
    if (!(piece.seconds_per_tick > 0.0)) kernel.refuse(values[i + 2], "the rate is not positive");
    if (!clock.pieces.empty()) {
      if (!(piece.ticks > clock.pieces.back().ticks))
        kernel.refuse(values[i],
                      "the ticks do not increase, after " + detail::text(clock.pieces.back().ticks));
      if (!(piece.time > clock.pieces.back().time))
        kernel.refuse(values[i + 1],
                      "the times do not increase, after " + detail::text(clock.pieces.back().time) + " s");
    }
    clock.pieces.push_back(piece);
  }
}

/// The numbers of a text of a clock, from left to right.
std::vector<double> clock_fields(const detail::ClockNumbers& clock, std::string_view text,
                                 const std::string& what) {
  std::vector<double> fields;
  while (true) {
    const auto stop = text.find_first_of(clock_separators);
    const std::string_view field = text.substr(0, stop);
    constexpr std::size_t longest = 15;  // digits that a double has
    const auto number = detail::parse_number(field);
    if (field.find_first_not_of("0123456789") != std::string_view::npos || field.size() > longest || !number)
      throw BadInput(what + "the field '" + detail::excerpt(field) + "' is not a whole number");
    fields.push_back(*number);
    if (fields.size() > clock.moduli.size())
      throw BadInput(what + "the clock has " + detail::text(clock.moduli.size()) + " fields");
    if (stop == std::string_view::npos) return fields;
    text.remove_prefix(stop + 1);
  }
}

}  // namespace

SpacecraftClock::SpacecraftClock(std::shared_ptr<const detail::ClockNumbers> numbers)
    : numbers_(std::move(numbers)) {}

SpacecraftClock SpacecraftClock::of(const TextKernel& kernel, std::int32_t clock) {
  // The names have the number with its sign turned.
  const std::string end = detail::text(-std::int64_t{clock});
  auto numbers = std::make_shared<detail::ClockNumbers>();
  numbers->place = kernel.place() + ", clock " + detail::text(clock);
  numbers->id = clock;
  const std::string type = "SCLK_DATA_TYPE_" + end, system = "SCLK01_TIME_SYSTEM_" + end;
  if (kernel.integer(type) != 1)
    kernel.refuse(type, "is " + detail::text(kernel.integer(type)) + "; only type 1 is known");
  if (kernel.find(system)) {
    const std::int32_t which = kernel.integer(system);
    if (which != 1 && which != 2)
      kernel.refuse(system, "is " + detail::text(which) + "; it is 1, TDB, or 2, TT");
    numbers->is_tdb = which == 1;
  }
  read_fields(kernel, end, *numbers);
  read_partitions(kernel, end, *numbers);
  read_pieces(kernel, end, *numbers);
  return SpacecraftClock(std::move(numbers));
}

SpacecraftClock SpacecraftClock::read(const std::filesystem::path& file, std::int32_t clock) {
  return of(TextKernel::read(file), clock);
}

std::int32_t SpacecraftClock::id() const {
  return numbers_->id;
}

Epoch SpacecraftClock::epoch(const ClockTicks& ticks) const {
  const auto& clock = *numbers_;
  const double count = ticks.count;
  if (!(count >= clock.pieces.front().ticks && count <= clock.end() + rounding(detail::trusted, clock.end())))
    throw BadInput(clock.place + ": it knows no time of " + detail::text(count) + " ticks, only of " +
                   detail::text(clock.pieces.front().ticks) + " to " + detail::text(clock.end()));
  const ClockPiece& piece = clock.piece_of(count);
  const detail::SecondsSince2000 time{piece.time, (count - piece.ticks) * piece.seconds_per_tick};
  return clock.is_tdb ? detail::epoch_of_ephemeris_time(time, clock.place)
                      : detail::epoch_of_terrestrial_time(time, clock.place);
}

ClockTicks SpacecraftClock::ticks(const Epoch& epoch) const {
  const auto& clock = *numbers_;
  const auto time = clock.is_tdb ? detail::ephemeris_time(epoch) : detail::terrestrial_time(epoch);
  const auto next = std::upper_bound(
      clock.pieces.begin(), clock.pieces.end(), time,
      [](const detail::SecondsSince2000& t, const ClockPiece& piece) { return t.since(piece.time) < 0.0; });
  if (next == clock.pieces.begin()) throw BadInput(clock.place + ": it begins after " + detail::shown(epoch));
  const ClockPiece& piece = *std::prev(next);
  const double count = piece.ticks + time.since(piece.time) / piece.seconds_per_tick;
  if (next == clock.pieces.end()) {
    if (!(count <= clock.end() + rounding(detail::trusted, clock.end())))
      throw BadInput(clock.place + ": its last partition ends before " + detail::shown(epoch));
    return {count};
  }
  return {std::min(count, next->ticks)};  // the pieces may overlap a little
}

ClockTicks SpacecraftClock::ticks(std::string_view text) const {
  const auto& clock = *numbers_;
  const std::string what = clock.place + ": '" + detail::excerpt(text) + "': ";
  std::string_view rest = detail::trimmed(text);
  std::size_t wanted = 0;
  if (const auto slash = rest.find('/'); slash != std::string_view::npos) {
    const std::string_view number = rest.substr(0, slash);
    const auto partition = detail::parse_number(number);
    if (number.find_first_not_of("0123456789") != std::string_view::npos || !partition || *partition < 1.0 ||
        *partition > static_cast<double>(clock.partitions.size()))
      throw BadInput(what + "the partitions are 1 to " + detail::text(clock.partitions.size()));
    wanted = static_cast<std::size_t>(*partition);
    rest.remove_prefix(slash + 1);
  }
  const auto fields = clock_fields(clock, rest, what);
  double count = 0.0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double field = fields[i] - clock.offsets[i];
    if (field < 0.0 || field >= clock.moduli[i])
      throw BadInput(what + "field " + detail::text(i + 1) + " is " + detail::text(fields[i]) +
                     "; it counts from " + detail::text(clock.offsets[i]) + " to " +
                     detail::text(clock.offsets[i] + clock.moduli[i] - 1.0));
    count += field * clock.units[i];
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < clock.partitions.size(); ++i) {
    const ClockPartition& partition = clock.partitions[i];
    if (!(count >= partition.start && count <= partition.end) || (wanted != 0 && wanted != i + 1)) continue;
    if (found != 0)
      throw BadInput(what + "the partitions " + detail::text(found) + " and " + detail::text(i + 1) +
                     " have this count");
    found = i + 1;
  }
  if (found == 0)
    throw BadInput(what + (wanted == 0 ? "no" : "this") + " partition " +
                   (wanted == 0 ? "has" : "does not have") + " the count " + detail::text(count));
  const ClockPartition& partition = clock.partitions[found - 1];
  return {partition.before + (count - partition.start)};
}

std::string SpacecraftClock::text(const ClockTicks& ticks) const {
  const auto& clock = *numbers_;
  const double count = std::round(ticks.count);
  if (!(count >= 0.0 && count <= clock.end()))
    throw BadInput(clock.place + ": no partition has " + detail::text(ticks.count) + " ticks");
  std::size_t which = 0;
  while (which + 1 < clock.partitions.size() && count >= clock.partitions[which + 1].before) ++which;
  double rest = count - clock.partitions[which].before + clock.partitions[which].start;
  std::string text = detail::text(which + 1) + "/";
  for (std::size_t i = 0; i < clock.units.size(); ++i) {
    const double field = std::floor(rest / clock.units[i]);
    rest -= field * clock.units[i];
    if (i != 0) text += clock.delimiter;
    const std::string digits = detail::text(static_cast<std::uint64_t>(field + clock.offsets[i]));
    const auto width =
        detail::text(static_cast<std::uint64_t>(clock.offsets[i] + clock.moduli[i] - 1.0)).size();
    text += std::string(width - std::min(width, digits.size()), '0') + digits;
  }
  return text;
}

double SpacecraftClock::rounding(detail::Trusted, double ticks) const {
  constexpr double ulps = 4.0, epsilon = 2.220446049250313e-16, of_epochs = 1e-10;  // s
  const ClockPiece& last = numbers_->pieces.back();
  return ulps * epsilon * std::abs(ticks) +
         (of_epochs + ulps * epsilon * std::abs(last.time)) / last.seconds_per_tick;
}

double SpacecraftClock::seconds_per_tick(detail::Trusted, double ticks) const {
  return numbers_->piece_of(ticks).seconds_per_tick;
}

}  // namespace vectrix
