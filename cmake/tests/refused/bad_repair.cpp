// mistake: a length is no number; and the repair compiles only with a warning
// expect: Metres
struct Metres {};

int use() {
#ifdef REPAIRED
  int shadowed = 1;
  {
    int shadowed = 2;
    return shadowed;
  }
#else
  return Metres{};
#endif
}
