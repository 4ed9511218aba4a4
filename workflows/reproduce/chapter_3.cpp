#include "workflows/reproduce/list.hpp"
#include "workflows/star/chapter.hpp"

namespace mesobridge::workflows {

Reproduced reproduce_chapter_3(ReproduceOptions const& options, Context const& context) {
  auto const chapter = run_chapter(chapter_plan(options.preset, options.seed), options.directory, context);
  return {chapter_summary(chapter), chapter_report(chapter)};
}

} // namespace mesobridge::workflows
