#include <vectrix/space/fields/exponential_atmosphere.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix {
namespace {

struct ValladoLayer {
  double base, density, scale_height;  // km, kg/m^3, km
};

// Vallado, Fundamentals of Astrodynamics and Applications, table 8-4.
constexpr ValladoLayer vallado_layers[] = {
    {0, 1.225, 7.249},        {25, 3.899e-2, 6.349},    {30, 1.774e-2, 6.682},    {40, 3.972e-3, 7.554},
    {50, 1.057e-3, 8.382},    {60, 3.206e-4, 7.714},    {70, 8.770e-5, 6.549},    {80, 1.905e-5, 5.799},
    {90, 3.396e-6, 5.382},    {100, 5.297e-7, 5.877},   {110, 9.661e-8, 7.263},   {120, 2.438e-8, 9.473},
    {130, 8.484e-9, 12.636},  {140, 3.845e-9, 16.149},  {150, 2.070e-9, 22.523},  {180, 5.464e-10, 29.740},
    {200, 2.789e-10, 37.105}, {250, 7.248e-11, 45.546}, {300, 2.418e-11, 53.628}, {350, 9.518e-12, 53.298},
    {400, 3.725e-12, 58.515}, {450, 1.585e-12, 60.828}, {500, 6.967e-13, 63.822}, {600, 1.454e-13, 71.835},
    {700, 3.614e-14, 88.667}, {800, 1.170e-14, 124.64}, {900, 5.245e-15, 181.05}, {1000, 3.019e-15, 268.00}};

}  // namespace

ExponentialAtmosphere ExponentialAtmosphere::vallado() {
  std::vector<Layer> layers;
  for (const ValladoLayer& layer : vallado_layers) {
    layers.push_back({Quantity<si::density>::from_value(layer.density), 1e3 * layer.base * si::metre,
                      1e3 * layer.scale_height * si::metre});
  }
  return ExponentialAtmosphere(std::move(layers));
}

ExponentialAtmosphere::ExponentialAtmosphere(std::vector<Layer> layers) : layers_(std::move(layers)) {}

ExponentialAtmosphere::ExponentialAtmosphere(const Layer& layer) : layers_{layer} {
  const auto require = [](bool valid, const char* what, double value, const char* unit) {
    if (!valid || !std::isfinite(value)) {
      throw BadInput(std::string{"ExponentialAtmosphere: the "} + what + " is " + detail::text(value) + unit);
    }
  };
  const double density = layer.density.value(), scale_height = layer.scale_height.value();
  require(density > 0.0, "density", density, " kg/m^3");
  require(true, "base", layer.base.value(), " m");
  require(scale_height > 0.0, "scale height", scale_height, " m");
}

Quantity<si::density> ExponentialAtmosphere::density(const Quantity<si::length>& height) const {
  const double h = height.value();
  if (!(h >= 0.0 && std::isfinite(h))) {
    throw BadInput("ExponentialAtmosphere: the height " + detail::text(h) + " m is not above the ellipsoid");
  }
  const auto above = std::upper_bound(layers_.begin() + 1, layers_.end(), height,
                                      [](const auto& x, const Layer& layer) { return x < layer.base; });
  const Layer& layer = *(above - 1);
  return std::exp((layer.base - height).value() / layer.scale_height.value()) * layer.density;
}

Quantity<si::density> ExponentialAtmosphere::density(const Vector<earth::Itrf, si::length>& r_itrf) const {
  return density(wgs84::geodetic(r_itrf).height);
}

}  // namespace vectrix
