#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/lj/state_grid_file.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

std::string table_text(cg::StateGrid const& grid) {
  std::string text =
      fmt::format("{:>7} {:>7}  {:<24} {:<24} {:<18}\n", "rho*", "T*", "P*", "U*", "C_V/N k_B");
  for (auto const& point : grid.points)
    text += fmt::format("{:7.4f} {:7.4f}  {:<24} {:<24} {:<18}\n", point.rho, point.T,
                        with_error_text(point.P), with_error_text(point.U), with_error_text(point.c_v));
  return text;
}

Result state_grid(std::filesystem::path const& input, Context const& context) {
  auto const data = read_lj_grid(input);
  auto const analysed = analyse_lj_grid(data);
  for (auto const& reason : analysed.left_out)
    context.log->warn("left out: {}", reason);
  auto const directory = context.output_directory(input.parent_path().empty() ? "." : input.parent_path());
  Provenance const provenance{.command = context.command_line(),
                              .seed = context.options.seed.value_or(0),
                              .scene = "",
                              .inputs = {input}};
  auto const file = directory / "state-grid.h5";
  write_state_grid(file, analysed.grid, provenance);
  Result result;
  result.json = {{"file", file.string()},
                 {"units", "reduced Lennard-Jones, per atom"},
                 {"settings", data.description},
                 {"left_out", analysed.left_out},
                 {"states", state_grid_json(analysed.grid)}};
  write_summary(directory / "state-grid.json", result.json);
  result.text = table_text(analysed.grid) + file.string();
  return result;
}

void declare(CLI::App& app, std::filesystem::path& input) {
  app.add_option("file", input, "What `md lj-grid` wrote")->required()->type_name("FILE.h5");
}

} // namespace

extern Declaration const cg_state_grid_command = with_options<std::filesystem::path, declare, state_grid>;

} // namespace mesobridge::workflows
