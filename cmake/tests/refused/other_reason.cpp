// mistake: refused, but not for the reason it gives
// expect: Metres
// expect: Gyroscope
struct Metres {};

#ifdef REPAIRED
Metres length;
#else
int length = Metres{};
#endif
