#include "workflows/reproduce/list.hpp"
#include "workflows/size_study/report.hpp"

namespace mesobridge::workflows {

Reproduced reproduce_table_5_1(ReproduceOptions const& options, Context const& context) {
  auto const parts = options.directory / "parts";
  std::error_code ignored;
  std::filesystem::create_directories(parts, ignored); // writing there says what is wrong
  auto const study = run_size_study(options.preset, options.seed, options.threads, parts, context);
  return {.summary = size_study_json(study), .report = size_study_report(study)};
}

} // namespace mesobridge::workflows
