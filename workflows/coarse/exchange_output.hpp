#pragma once
#include "cg/energy_exchange.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// A weight of conduction over the distance, with its standard error.
struct ConductionRow {
  double r;
  cg::Estimate kappa;
};

/// Columns r and kappa, as scenes read them (conduction.file).
std::string conduction_csv(cg::ConductionTable const& table);

Json exchange_json(cg::EnergyExchange const& found, std::vector<ConductionRow> const& rows,
                   cg::ConductionTable const& table);
std::string exchange_text(cg::EnergyExchange const& found);

/// How energies decay and pass to neighbours, and the conduction that follows.
Report exchange_report(cg::EnergyExchange const& found, std::vector<ConductionRow> const& rows,
                       cg::ConductionTable const& table, std::string const& name, std::string const& units);

} // namespace mesobridge::workflows
