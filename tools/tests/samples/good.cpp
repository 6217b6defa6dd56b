// What a file of refused programs looks like
struct Metres {};
struct Seconds {};

void wait(Seconds);
void wait(Metres) = delete;  // wait(time)

namespace metres_for_seconds {
// mistake: metres are handed to a door that wants seconds
// expect: [Ww]ait
// expect: Metres
void use() {
#ifdef REPAIRED
  wait(Seconds{});
#else
  wait(Metres{});
#endif
}
}  // namespace metres_for_seconds

namespace metres_in_a_template {
// mistake: the error is in a template, and belongs to the case that instantiates it
// expect: Metres
template <class Given> void pass(const Given& given) {
  wait(given);
}

void use() {
#ifdef REPAIRED
  pass(Seconds{});
#else
  pass(Metres{});
#endif
}
}  // namespace metres_in_a_template
