#include "workflows/command/options.hpp"
#include "workflows/eos/columns.hpp"
#include "workflows/eos/detonation_options.hpp"
#include "workflows/eos/mixture_columns.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosExplosionOptions {
  ReactionOptions explosive;
  double lambda = 1;
};

Result explosion(EosExplosionOptions const& options, Context const& context) {
  require(options.lambda >= 0 && options.lambda <= 1, "--lambda", options.lambda, "must lie in [0, 1]");
  auto const fluid = options.explosive.fluid(context);
  auto const& rest = fluid.at_rest;
  auto const columns = mixture_columns(rest.rho, fluid.exploded(rest.rho, rest.e, options.lambda));
  Result result;
  result.json = options.explosive.detonation.names();
  result.json["lambda"] = options.lambda;
  tell_first_row(result, columns, false);
  result.json["q_J_kg"] = fluid.q;
  put_first_row(result.json["at_rest"], state_columns({rest}), false);
  return result;
}

void declare(CLI::App& app, EosExplosionOptions& options) {
  options.explosive.declare(app);
  app.add_option("--lambda", options.lambda, "Progress of the reaction, 0 to 1")->capture_default_str();
  app.description("The state that an explosive comes to when it reacts at constant volume and loses no heat: "
                  "e = e_0 + q lambda at the initial density.");
}

} // namespace

extern Declaration const eos_explosion_command = with_options<EosExplosionOptions, declare, explosion>;

} // namespace mesobridge::workflows
