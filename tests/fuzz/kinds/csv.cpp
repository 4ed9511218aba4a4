#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "soft_scene.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::fuzz {
namespace {

namespace fs = std::filesystem;

void prepare(fs::path const& folder) {
  workflows::write_text_file(folder / "hugoniot.csv",
                             "# copper-like, made up\nrho0_kg_m3,T0_K,v_P_m_s,v_S_m_s,v_S_se_m_s\n"
                             "8930,293,400,4535,20\n8930,293,800,5130,20\n8930,293,1200,5730,20\n"
                             "8930,293,1600,6320,20\n8930,293,2000,6920,20\n");
  workflows::write_text_file(
      folder / "detonation.csv",
      R"(kind,rho0_g_cm3,e0_MJ_kg,P0_GPa,rho_g_cm3,T_K,T_se_K,P_GPa,P_se_GPa,D_km_s,D_se_km_s
cj,1.717,4.9505,0,,,,29.5,0.295,7.98,0.0399
isentrope,2.351419,,29.500000,2.305312,,,27.94968600,0.27949686,,
isentrope,2.351419,,29.500000,1.964381,,,17.57243497,0.17572435,,
isentrope,2.351419,,29.500000,1.673869,,,10.58507238,0.10585072,,
isentrope,2.351419,,29.500000,1.426322,,,6.22673936,0.06226739,,
isentrope,2.351419,,29.500000,1.215384,,,3.69331907,0.03693319,,
isentrope,2.351419,,29.500000,1.035641,,,2.28521500,0.02285215,,
isentrope,2.351419,,29.500000,0.882481,,,1.49498775,0.01494988,,
isentrope,2.351419,,29.500000,0.751971,,,1.01688128,0.01016881,,
isentrope,2.351419,,29.500000,0.640762,,,0.69859162,0.00698592,,
isentrope,2.351419,,29.500000,0.546000,,,0.47567520,0.00475675,,
isentrope,2.351419,,29.500000,0.465252,,,0.32078063,0.00320781,,
isentrope,2.351419,,29.500000,0.396446,,,0.21736521,0.00217365,,
isentrope,2.351419,,29.500000,0.337816,,,0.15119954,0.00151200,,
isentrope,2.351419,,29.500000,0.287857,,,0.10975161,0.00109752,,
isentrope,2.351419,,29.500000,0.245286,,,0.08328262,0.00083283,,
)");
  workflows::write_text_file(
      folder / "soft.csv",
      "r,u,f\n0.1,20.25,45\n0.3,12.25,35\n0.5,6.25,25\n0.7,2.25,15\n0.9,0.25,5\n1.0,0,0\n");
  workflows::write_text_file(folder / "soft.toml",
                             tests::SoftScene{.method = "dpd",
                                              .run = "equilibrate = 10\nsteps = 64\nsample_every = 2\n",
                                              .potential = "file = \"soft.csv\"\n"}
                                 .text());
}

void change(Random& random, Trial& trial) {
  std::vector<std::string> const copper{
      "fit",       "mie-gruneisen", "hugoniot.csv", "--m0",     "63.546 u", "--fix",
      "Gamma_0=2", "--fix",         "Gamma_inf=0",  "--fix",    "q=1",      "--fix",
      "c_v=385",   "--local",       "-o",           "out.toml", "--quiet"};
  switch (random.below(3)) {
  case 0:
    trial.commands = {
        copper, {"eos", "hugoniot", "--model", "out.toml", "--rho0", "8930", "--T0", "293", "--vp", "1000"}};
    trial.change = change_text(random, trial.folder / "hugoniot.csv");
    break;
  case 1:
    trial.commands = {{"fit", "jwl", "detonation.csv", "--m0", "227 u", "--fix", "rho_0=1717", "--local",
                       "-o", "out.toml", "--quiet"}};
    trial.change = change_text(random, trial.folder / "detonation.csv");
    break;
  default:
    trial.commands = {{"run", "soft.toml", "-o", "out", "--quiet", "--threads", "1"}};
    trial.change = change_text(random, trial.folder / "soft.csv");
  }
}

} // namespace

Kind csv_kind() {
  return {.name = "csv", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
