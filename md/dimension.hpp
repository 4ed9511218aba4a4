#pragma once

namespace mesobridge {

/// What a quantity measures: it decides which units it is read and written in.
enum class Dimension {
  number, ///< none
  mass,
  length,
  time,
  rate, ///< per time
  temperature,
  density,
  velocity,
  acceleration,
  momentum,
  pressure,
  energy,
  specific_energy,
  entropy,
  viscosity,
  friction,
  force,
  conductivity,
  conduction ///< of heat between two particles by their inverse temperatures
};

} // namespace mesobridge
