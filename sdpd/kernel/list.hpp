#pragma once
#include "sdpd/kernel/cubic.hpp"
#include "sdpd/kernel/lucy.hpp"
#include "sdpd/kernel/quintic.hpp"
#include "sdpd/kernel/wendland.hpp"
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mesobridge::sdpd {

/// Every kernel; the passes over the pairs choose once, outside their loops.
using AnyKernel = std::variant<CubicKernel, LucyKernel, QuinticKernel, WendlandC2Kernel, WendlandC4Kernel,
                               WendlandC6Kernel>;

/// The mean density that a sum over neighbours gives is not the mass per volume: the particle's own term is
/// too large or too small for the order of its surroundings. rho_i = scale sum_j m_j W_ij - self m_i W_ii(0),
/// with constants, keeps the dynamics Hamiltonian (sdpd/README.md, Eq. (S5)).
struct DensityCorrection {
  double scale = 1; ///< c, > 0
  double self = 0;  ///< epsilon, < c
  bool operator==(DensityCorrection const&) const = default;
};

/// "cubic", "lucy", "wendland-c2" ...
std::vector<std::string> kernel_names();

/// The kernel of that name with support h, multiplied by `scale`. Throws InputError that lists the names.
AnyKernel make_kernel(std::string_view name, double h, double scale = 1);

/// The self-term correction for particles at rest in a glass with `neighbours` N within the support, at which
/// the mean density is right. For Wendland's kernels that of Dehnen and Aly, epsilon = epsilon_100
/// (N/100)^-a (sdpd/README.md, Eq. (S6)). For the cubic and Lucy's kernels, whose glasses have densities
/// that are too low and from about 70 neighbours on clump, a constant that glasses of our own gave (a test
/// makes them again). A hot fluid is no glass: its constants have to be found on the fluid itself
/// (calibrate_density.hpp). Throws InputError for other kernels and numbers of neighbours.
DensityCorrection glass_correction(std::string_view kernel, double neighbours);

/// What a particle adds to its own density; the kernel has the scale of the correction.
double self_density(AnyKernel const& kernel, DensityCorrection const& correction);

} // namespace mesobridge::sdpd
