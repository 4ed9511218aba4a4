#pragma once
#include "fitting/power_law.hpp"
#include "workflows/report/plot.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/study/study.hpp"

namespace mesobridge::workflows {

/// The ideal gas of the thesis's chapter 4: m0 = 1e-25 kg, 1150 kg/m^3, 1000 K, eta = 2e-3 Pa s.
Scene thesis_ideal_gas(double K, std::string const& scheme, std::uint64_t seed);

/// One curve of a figure: a scene over several time steps.
struct StudyLine {
  std::string label;
  Scene scene;
  std::vector<double> dt; ///< reduced
  double time;            ///< reduced, sampled
  std::optional<cg::Bins> bins = {};
};

struct LineResult {
  std::string label;
  std::vector<double> dt;
  std::vector<sdpd::TrialResult> trials;

  /// The time steps of the trials that went through, and a value of each.
  template <class F>
  std::pair<std::vector<double>, std::vector<cg::Estimate>> values(F const& value) const {
    std::pair<std::vector<double>, std::vector<cg::Estimate>> result;
    for (std::size_t k = 0; k < dt.size(); ++k)
      if (!trials[k].failed())
        result.first.push_back(dt[k]), result.second.push_back(value(trials[k]));
    return result;
  }
  /// The time steps and rates of the trials that know their drift, as some do that failed late.
  std::pair<std::vector<double>, std::vector<cg::Estimate>> drifts() const;
  fitting::PowerLaw drift_law() const; ///< of those that went through
};

/// Runs all lines; trials are stored under the directory, so that an interrupted reproduction goes on.
std::vector<LineResult> run_lines(std::string const& title, std::vector<StudyLine> const& lines,
                                  ReproduceOptions const& options, Context const& context);

/// How long the trials of a preset sample, as a multiple of the quick ones, and how many particles they have.
struct RunLength {
  double length;
  std::int64_t particles;
};
RunLength run_length_of(md::Preset preset);

/// Points with errors over the time step, without those whose error reaches zero.
Series resolved_points(std::string label, std::vector<double> const& x, std::vector<cg::Estimate> const& y,
                       int colour);

/// An empty plot of a value over the time step.
Plot over_time_step(std::string name, std::string title, std::string y, bool logarithmic);

/// The relative energy error in time of every trial that went through.
Plot energy_in_time(std::string name, std::string title, std::vector<LineResult> const& lines);

/// All numbers of the lines.
Json lines_json(std::vector<LineResult> const& lines);

/// Drift rates and what they are made of, a row a trial.
Table drift_table(std::vector<LineResult> const& lines);

/// What can be said of every trial that failed.
std::vector<std::string> failures(std::vector<LineResult> const& lines);

} // namespace mesobridge::workflows
