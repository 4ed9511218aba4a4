#include "workflows/report/sources.hpp"
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace mesobridge::workflows {

std::span<Source const> all_sources() {
  static constexpr std::array<Source, 18> sources{{
      {"Dehnen and Aly 2012", "W. Dehnen, H. Aly",
       "Improving convergence in smoothed particle hydrodynamics simulations without pairing instability",
       "Mon. Not. R. Astron. Soc. 425, 1068-1082", 2012, "https://doi.org/10.1111/j.1365-2966.2012.21439.x"},
      {"Espanol and Revenga 2003", "P. Español, M. Revenga", "Smoothed dissipative particle dynamics",
       "Phys. Rev. E 67, 026705", 2003, "https://doi.org/10.1103/PhysRevE.67.026705"},
      {"Faure 2017", "G. Faure", "Micro/hydro coupling for the simulation of detonation and shock waves",
       "PhD thesis, Université Paris-Est (in these reports: the thesis)", 2017,
       "https://pastel.hal.science/tel-01789719"},
      {"Faure et al. 2016", "G. Faure, J.-B. Maillet, J. Roussel, G. Stoltz",
       "Size consistency in smoothed dissipative particle dynamics", "Phys. Rev. E 94, 043305", 2016,
       "https://doi.org/10.1103/PhysRevE.94.043305"},
      {"Flyvbjerg and Petersen 1989", "H. Flyvbjerg, H. G. Petersen",
       "Error estimates on averages of correlated data", "J. Chem. Phys. 91, 461-466", 1989,
       "https://doi.org/10.1063/1.457480"},
      {"Gronbech-Jensen and Farago 2013", "N. Grønbech-Jensen, O. Farago",
       "A simple and effective Verlet-type algorithm for simulating Langevin dynamics",
       "Mol. Phys. 111, 983-991", 2013, "https://doi.org/10.1080/00268976.2012.760055"},
      {"Hijon et al. 2010", "C. Hijón, P. Español, E. Vanden-Eijnden, R. Delgado-Buscalioni",
       "Mori-Zwanzig formalism as a practical computational tool", "Faraday Discuss. 144, 301-322", 2010,
       "https://doi.org/10.1039/B902479B"},
      {"Hubber et al. 2018", "D. A. Hubber, G. P. Rosotti, R. A. Booth",
       "GANDALF - Graphical Astrophysics code for N-body Dynamics And Lagrangian Fluids",
       "Mon. Not. R. Astron. Soc. 473, 1603-1632", 2018, "https://doi.org/10.1093/mnras/stx2405"},
      {"Izvekov and Voth 2005", "S. Izvekov, G. A. Voth",
       "A multiscale coarse-graining method for biomolecular systems", "J. Phys. Chem. B 109, 2469-2473",
       2005, "https://doi.org/10.1021/jp044629q"},
      {"Johnson et al. 1993", "J. K. Johnson, J. A. Zollweg, K. E. Gubbins",
       "The Lennard-Jones equation of state revisited", "Mol. Phys. 78, 591-618", 1993,
       "https://doi.org/10.1080/00268979300100411"},
      {"Kolafa and Nezbeda 1994", "J. Kolafa, I. Nezbeda",
       "The Lennard-Jones fluid: an accurate analytic and theoretically-based equation of state",
       "Fluid Phase Equilib. 100, 1-34", 1994, "https://doi.org/10.1016/0378-3812(94)80001-4"},
      {"Noid et al. 2008",
       "W. G. Noid, J.-W. Chu, G. S. Ayton, V. Krishna, S. Izvekov, G. A. Voth, A. Das, H. C. Andersen",
       "The multiscale coarse-graining method. I. A rigorous bridge between atomistic and coarse-grained "
       "models",
       "J. Chem. Phys. 128, 244114", 2008, "https://doi.org/10.1063/1.2938860"},
      {"Palmer 1994", "B. J. Palmer",
       "Transverse-current autocorrelation-function calculations of the shear viscosity for molecular "
       "liquids",
       "Phys. Rev. E 49, 359-366", 1994, "https://doi.org/10.1103/PhysRevE.49.359"},
      {"Shardlow 2003", "T. Shardlow", "Splitting for dissipative particle dynamics",
       "SIAM J. Sci. Comput. 24, 1267-1282", 2003, "https://doi.org/10.1137/S1064827501392879"},
      {"Thol et al. 2016", "M. Thol, G. Rutkai, A. Köster, R. Lustig, R. Span, J. Vrabec",
       "Equation of state for the Lennard-Jones fluid", "J. Phys. Chem. Ref. Data 45, 023101", 2016,
       "https://doi.org/10.1063/1.4945000"},
      {"Thompson et al. 2022",
       "A. P. Thompson, H. M. Aktulga, R. Berger, D. S. Bolintineanu, W. M. Brown, P. S. Crozier, P. J. in "
       "'t "
       "Veld, A. Kohlmeyer, S. G. Moore, T. D. Nguyen, R. Shan, M. J. Stevens, J. Tranchida, C. Trott, S. J. "
       "Plimpton",
       "LAMMPS - a flexible simulation tool for particle-based materials modeling at the atomic, meso, and "
       "continuum scales",
       "Comput. Phys. Commun. 271, 108171", 2022, "https://doi.org/10.1016/j.cpc.2021.108171"},
      {"Wolff 2004", "U. Wolff", "Monte Carlo errors with less errors", "Comput. Phys. Commun. 156, 143-153",
       2004, "https://doi.org/10.1016/S0010-4655(03)00467-3"},
      {"Yeh and Hummer 2004", "I.-C. Yeh, G. Hummer",
       "System-size dependence of diffusion coefficients and viscosities from molecular dynamics simulations "
       "with periodic boundary conditions",
       "J. Phys. Chem. B 108, 15873-15879", 2004, "https://doi.org/10.1021/jp0477147"},
  }};
  return sources;
}

Source const& source(std::string_view key) {
  auto const all = all_sources();
  auto const found = std::ranges::find(all, key, &Source::key);
  if (found == all.end())
    throw std::logic_error("no source is known as '" + std::string(key) + "'");
  return *found;
}

} // namespace mesobridge::workflows
