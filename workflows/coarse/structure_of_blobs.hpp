#pragma once
#include "workflows/coarse/potential_search.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// What a coarse fluid of the same molecules is to have: density, mass, temperature of the centres of mass,
/// radial distribution in bins of about `width` up to half of the box, and the pressure
/// where the file has one. Throws InputError
/// for isolated molecules, or a box of another size in each frame.
CoarseStructure structure_of(BlobData const& data, double width);

/// The same of molecules whose centres stand in R, number frame * molecules + molecule, without a pressure.
CoarseStructure structure_of(BlobFileHead const& head, std::vector<Box> const& boxes,
                             std::vector<Vec3> const& R, double kT, double width);

/// k_B T, the motion of all together taken out: of all atoms of our own melts, and of the centres of mass of
/// molecules of any origin, whose atoms need not move freely. Throws InputError where they are at rest.
double kT_of(BlobData const& data);

/// Beyond which g stays within 0.02 of one; for a potential that is to keep the pressure 1.3 times as far,
/// since a tail that g hardly feels needs the room. At most 0.8 of the bins, beside which lists of neighbours
/// have their skin.
double usual_cutoff(cg::RadialBins const& bins, bool at_pressure);

} // namespace mesobridge::workflows
