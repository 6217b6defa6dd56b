// What magnetic field and what gravity does a cubesat meet on one revolution?
//
//     Satellite --- Teme --- Itrf --- Gcrf --- Lvlh
//
//     r^teme, v^teme      SGP4 from two-line elements; the axes of Satellite are those of Teme
//     R_itrf^teme, w      sidereal time of 1982 and the observed pole: the Earth as SGP4 sees it
//     R_itrf^gcrf, w      IAU 2006/2000A, observed by the IERS
//     R_gcrf^lvlh         z to the centre, y along -(r x v), from r^gcrf and v^gcrf that the graph provides
//
// Both fields are functions of r^itrf and give a vector in Itrf; the graph takes it to the axes where it is
// needed:
//     B^lvlh = R_itrf^lvlh B^itrf(r^itrf, t)         IGRF-14
//     g^lvlh = R_itrf^lvlh g^itrf(r^itrf)            EGM2008 to degree 20
// A magnetorquer with the dipole m^lvlh along y gives the torque m x B: none about y, the pitch axis.
//
// Expected results: 20000 to 50000 nT, the more, the nearer to a magnetic pole, down in the north and up in
// the south; the flattening of the Earth turns gravity by up to 5 arcmin at 45 deg of latitude and changes it
// by a thousandth.
//
//     field_along_orbit [data directory]

#include <cstdio>
#include <exception>
#include <filesystem>

#include <vectrix/space.hpp>

#ifndef VECTRIX_EXAMPLE_DATA
#define VECTRIX_EXAMPLE_DATA "examples/data"
#endif

namespace {

using namespace vectrix;
using earth::Gcrf, earth::Itrf, earth::Teme;

struct Satellite : moving_frame {};
struct Lvlh : moving_frame {};

void run(const std::filesystem::path& data) {
  const auto orientation = EarthOrientation::read(data / "finals2000A_april_2023.txt");
  const auto set = TwoLineElements::read(data / "CTIM_20230419.tle").front();
  const Sgp4<Satellite> orbit(set, at_most(1.0 * si::day));
  const auto graph = frame_graph(edge(orientation), edge(teme(orientation)), edge(orbit),
                                 edge([](const Displacement<Gcrf, Satellite, In<Gcrf>>& r,
                                         const Velocity<Gcrf, Satellite, ObservedFrom<Gcrf>, In<Gcrf>>& v) {
                                   return lvlh(from<Lvlh>, r, v);
                                 }));

  const auto igrf = MagneticField::igrf14();
  const auto egm = GravityField::egm2008();
  const auto dipole = vector(in<Lvlh>, 0.0 * si::ampere_square_metre, 0.1 * si::ampere_square_metre,
                             0.0 * si::ampere_square_metre);

  std::printf("%s, from %s UTC. B and torque: x forward, y along -(r x v), z down.\n\n", set.title().c_str(),
              set.epoch().utc(0).c_str());
  constexpr const char* columns = "%5s %7s %8s %7s %8s %8s %8s %8s %7s %7s %8s %7s\n";
  std::printf(columns, "", "north", "east", "height", "|B|", "Bx", "By", "Bz", "Tx", "Tz", "g", "g off z");
  std::printf(columns, "min", "deg", "deg", "km", "nT", "nT", "nT", "nT", "uN m", "uN m", "m/s^2", "arcmin");
  const auto revolution = from_until(set.epoch(), convert<si::time>(95.0 * si::minute));
  for (const Epoch& t : every(convert<si::time>(5.0 * si::minute), revolution)) {
    const auto now = graph.at(t);
    const auto r_itrf = now.position(of<Satellite>, relative_to<Itrf>, in<Itrf>);
    const auto R_lvlh_from_itrf = now.rotation(to<Lvlh>, from<Itrf>);
    const auto B_lvlh = R_lvlh_from_itrf * igrf.at(r_itrf, t);
    const auto g_lvlh = R_lvlh_from_itrf * egm.acceleration(r_itrf);
    const Vector<Lvlh, si::torque> torque = cross(dipole, B_lvlh);
    const Geodetic below = wgs84::geodetic(r_itrf);
    std::printf("%5.0f %7.2f %8.2f %7.1f %8.0f %8.0f %8.0f %8.0f %7.2f %7.2f %8.5f %7.2f\n",
                (t - set.epoch()).in(si::minute), below.latitude.angle.in(si::degree),
                below.longitude.in(si::degree), below.height.in(si::kilometre),
                norm(B_lvlh).in(si::nanotesla), B_lvlh.x().in(si::nanotesla), B_lvlh.y().in(si::nanotesla),
                B_lvlh.z().in(si::nanotesla), 1e6 * torque.x().value(), 1e6 * torque.z().value(),
                norm(g_lvlh).value(), 60.0 * angle_between(g_lvlh, unit_z(in<Lvlh>)).in(si::degree));
  }
}

}  // namespace

int main(int count, char** words) {
  try {
    run(count > 1 ? words[1] : VECTRIX_EXAMPLE_DATA);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "field_along_orbit: %s\n", error.what());
    return 1;
  }
  return 0;
}
