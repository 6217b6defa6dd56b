// A sample: what a refused program looks like. It contains one mistake; REPAIRED takes only that away.
// mistake: metres are handed to a door that wants seconds
// expect: [Ww]ait
// expect: Metres
struct Metres {};
struct Seconds {};

void wait(Seconds);
void wait(Metres) = delete;  // wait(time)

void use() {
#ifdef REPAIRED
  wait(Seconds{});
#else
  wait(Metres{});
#endif
}
