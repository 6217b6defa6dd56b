// mistake: there is none
// expect: Metres
struct Metres {};

Metres use() {
#ifdef REPAIRED
#endif
  return {};
}
