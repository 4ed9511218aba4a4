#include "fuzz/judge.hpp"
#include "hdf5_numbers.hpp"
#include "workflows/command.hpp"
#include <fmt/format.h>
#include <regex>

namespace mesobridge::fuzz {
namespace {

namespace fs = std::filesystem;

/// A number that is none, printed as a word of its own (not "information", not a path).
std::string words_without_value(std::string const& printed) {
  static std::regex const none(R"((^|[\s=:,(\[])[-+]?(nan|inf|infinity)($|[\s,;)\]]))", std::regex::icase);
  std::smatch found;
  return std::regex_search(printed, found, none) ? found.str() : "";
}

/// What no command may do, whatever it was given.
std::string fault_of(Outcome const& outcome) {
  auto const& [status, hung, printed] = outcome;
  if (hung)
    return "hangs";
  if (status != 0 && status != 130 && (status < 2 || status > 4))
    return fmt::format("ends with status {}", status);
  if (printed.find("unexpected failure") != std::string::npos)
    return "an unexpected failure";
  if (status != 0 && status != 130 && printed.empty())
    return fmt::format("ends with status {} and says nothing", status);
  auto const word = status == 0 ? words_without_value(printed) : "";
  return word.empty() ? "" : fmt::format("prints '{}' and succeeds", word);
}

std::string fault_of_last(Trial const& trial, Outcome const& last) {
  if (last.status == 130)
    return "";
  if (last.status != 0)
    return trial.expected == Expected::success ? fmt::format("refused, with status {}", last.status) : "";
  if (trial.expected == Expected::refusal)
    return "succeeds, though it must refuse";
  auto const where = fs::exists(trial.folder / "out") ? tests::not_finite_in(trial.folder / "out") : "";
  return where.empty() ? "" : where + ", with success";
}

} // namespace

std::string fault_of(Trial const& trial, std::vector<Outcome> const& outcomes) {
  for (auto const& outcome : outcomes)
    if (auto fault = fault_of(outcome); !fault.empty())
      return fault;
  if (outcomes.size() == trial.commands.size())
    if (auto fault = fault_of_last(trial, outcomes.back()); !fault.empty())
      return fault;
  return trial.judge ? trial.judge(trial, outcomes) : "";
}

} // namespace mesobridge::fuzz
