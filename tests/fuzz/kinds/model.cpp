#include "fuzz/change_text.hpp"
#include "fuzz/child.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>

// Model files and mappings, damaged, and states at the ends of the numbers.

namespace mesobridge::fuzz {
namespace {

void prepare(std::filesystem::path const& folder) {
  workflows::write_text_file(
      folder / "hugoniot.csv",
      "rho0_kg_m3,T0_K,v_P_m_s,v_S_m_s,v_S_se_m_s\n8930,293,400,4535,20\n8930,293,800,5130,20\n"
      "8930,293,1200,5730,20\n8930,293,1600,6320,20\n");
  auto const fitted = run_in_child(folder,
                                   {"fit", "mie-gruneisen", "hugoniot.csv", "--m0", "63.546 u", "--fix",
                                    "Gamma_0=2", "--fix", "Gamma_inf=0", "--fix", "q=1", "--fix", "c_v=385",
                                    "--local", "-o", "model.toml", "--quiet"},
                                   60);
  if (!std::filesystem::exists(folder / "model.toml"))
    throw std::runtime_error("no model was fitted: " + fitted.printed);
}

std::string odd_state(Random& random) {
  static std::vector<std::string> const states{"1e-308", "5e-324", "1e-30", "1e-8",  "1",   "300",
                                               "1000",   "8930",   "9000",  "20000", "1e6", "1e30",
                                               "1e308",  "0",      "-1",    "nan",   "inf", "1e400"};
  return random.of(states);
}

std::vector<std::string> odd_question(Random& random, std::string const& model) {
  auto state = [&] { return odd_state(random); };
  switch (random.below(6)) {
  case 0:
    return {"eos", "eval", "--model", model, "--rho", state(), random.chance(0.5) ? "--T" : "--e", state()};
  case 1:
    return {"eos", "hugoniot", "--model", model, "--rho0", state(), "--T0", state(), "--vp", state()};
  case 2:
    return {"eos", "isentrope", "--model", model, "--rho0", state(), "--T0", state(), "--rho", state()};
  case 3:
    return {"eos",  "profile", "--model", model,   "--rho0", state(),
            "--T0", state(),   "--vp",    state(), "--eta",  "1e-3"};
  case 4:
    return {"eos",          "table", "--model",    model,   "--rho-min", state(),
            "--rho-max",    state(), "--T-min",    state(), "--T-max",   state(),
            "--rho-points", "3",     "--T-points", "3",     "-o",        "t.csv"};
  default:
    return {"eos",   "riemann",  "--left", model,         "--right", model,       "--rho-left",
            state(), "--T-left", state(),  "--rho-right", state(),   "--T-right", state()};
  }
}

void change(Random& random, Trial& trial) {
  static std::vector<std::string> const names{"model.toml", "argon",        "water",
                                              "tin",        "nitromethane", "ideal-gas",
                                              "lj-bwr",     "lj-thol",      "nitromethane-products"};
  auto const model = random.of(names);
  if (model == "model.toml")
    trial.change = change_text(random, trial.folder / "model.toml");
  auto words = model == "model.toml" && random.chance(0.5)
                   ? std::vector<std::string>{"eos", "eval", "--model", model, "--rho", "9000", "--T", "400"}
                   : odd_question(random, model);
  if (random.chance(0.5))
    words.push_back("--json");
  trial.commands = {words};
}

} // namespace

Kind model_kind() {
  return {.name = "model", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
