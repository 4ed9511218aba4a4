#pragma once
#include "workflows/size_study/study.hpp"
#include "workflows/study/stored_part.hpp"

/// What the stored parts of the size study are made of (see study/stored_part.hpp).
namespace mesobridge::workflows {

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, SizeCalibration>
void for_each_member(Result& c, F const& f) {
  f("kernel", c.kernel), f("K", c.K);
  f("scale", c.found.constants.scale), f("self", c.found.constants.self);
  f("scale_se", c.found.scale_se), f("self_se", c.found.self_se);
  f("rho", c.found.rho), f("P", c.found.P), f("P_eos", c.found.P_eos);
  f("particles", c.found.particles), f("steps", c.found.steps);
}
template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, FluidRun>
void for_each_member(Result& r, F const& f) {
  f("kernel", r.kernel), f("K", r.K), f("treatment", r.treatment);
  f("scale", r.constants.scale), f("self", r.constants.self);
  f("P", r.P), f("rho", r.rho), f("T_kin", r.T_kin), f("T_int", r.T_int);
  f("energy", r.energy), f("energy_expected", r.energy_expected);
  f("rho_i", r.rho_i), f("P_i", r.P_i);
}
template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, Structure>
void for_each_member(Result& s, F const& f) {
  f("kernel", s.kernel), f("r", s.r), f("g", s.g), f("pairs", s.pairs);
}

} // namespace mesobridge::workflows
