#pragma once
#include "cg/estimate.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"

namespace mesobridge::workflows {

/// What a `transport.json` tells: numbers with errors, and curves over the lags.
struct TransportResult {
  std::string name, units;
  std::vector<std::pair<std::string, cg::Estimate>> numbers; ///< by their keys: D, eta, ...
  std::vector<double> lag;
  std::vector<cg::Estimate> displacement, velocity;
};

/// Of the JSON that `cg transport` made; `file` is for messages. Throws InputError that names what is missing
/// or is no number.
TransportResult transport_result(Json const& json, std::filesystem::path const& file);

/// A transport.json itself, or the one in a folder.
std::filesystem::path transport_file(std::filesystem::path const& file_or_folder);
TransportResult read_transport(std::filesystem::path const& file_or_folder);

/// Two fluids in the same units: ratio and difference in standard errors of each number that both have.
/// Throws InputError for other units.
Json beside_json(TransportResult const& ours, TransportResult const& other);
std::string beside_text(TransportResult const& ours, TransportResult const& other);

/// Velocity correlation and displacements of one over those of the other, and the numbers of both.
Section beside_section(TransportResult const& ours, TransportResult const& other);

} // namespace mesobridge::workflows
