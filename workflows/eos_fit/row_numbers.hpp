#pragma once
#include "workflows/eos_fit/data_file.hpp"
#include "workflows/eos_fit/data_table.hpp"

namespace mesobridge::workflows {

/// A row's numbers in SI by what they are.
struct RowNumbers {
  std::map<fitting::Quantity, double> values, errors, start, start_errors;
  double P_e_correlation = 0;

  std::optional<double> value(fitting::Quantity quantity) const;
  std::optional<double> error(fitting::Quantity quantity) const;
  std::optional<double> start_of(fitting::Quantity quantity) const;
  std::optional<double> start_error(fitting::Quantity quantity) const;
};

/// Throws InputError for a quantity that is given twice.
RowNumbers numbers_of(DataRow const& row, std::map<std::string, DataColumn> const& columns);

/// What the row's column `kind` says, or its columns. Throws InputError.
fitting::DataPath path_of(DataRow const& row, RowNumbers const& numbers);

/// Where a shock or an isentrope starts.
std::optional<fitting::StartState> start_of(RowNumbers const& numbers, fitting::DataPath path);

/// What a shock's start says of the pressure of matter at rest; nothing where P0 itself is the start. Throws
/// InputError for standard errors that are not > 0.
std::optional<fitting::Observation::AtRest> at_rest(RowNumbers const& numbers,
                                                    std::optional<fitting::StartState> const& start,
                                                    std::string const& origin);

/// The standard error of a value: the row's own, or the relative one. Throws InputError where there is none.
double error_of(fitting::Quantity quantity, double value, RowNumbers const& numbers,
                RelativeErrors const& relative, std::string const& origin);

} // namespace mesobridge::workflows
