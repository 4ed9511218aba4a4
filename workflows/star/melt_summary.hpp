#pragma once
#include "workflows/star/blob_file.hpp"
#include "workflows/star/sample_melt.hpp"
#include "workflows/star/sample_molecules.hpp"

namespace mesobridge::workflows {

/// What `md star-melt` tells of a finished run: sizes, temperature, how well energy and momentum were kept,
/// how well the blobs' energies add up to LAMMPS's.
Json melt_summary(MeltJob const& job, BlobData const& data);

std::string melt_text(Json const& summary);

/// The same of `md molecules`. Energies are LAMMPS's, temperatures too; k_B [energy/temperature] joins them.
Json molecules_summary(MoleculesJob const& job, md::MoleculeMelt const& melt, BlobData const& data,
                       double boltzmann);

std::string molecules_text(Json const& summary);

} // namespace mesobridge::workflows
