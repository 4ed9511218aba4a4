#pragma once
#include "fuzz/trial.hpp"

namespace mesobridge::fuzz {

// One family a file; kinds() lists them.
Kind h5md_kind();
Kind dump_kind();
Kind blobs_kind();
Kind lj_grid_kind();
Kind resume_kind();
Kind journal_kind();
Kind csv_kind();
Kind scene_kind();
Kind driven_kind();
Kind reacting_kind();
Kind model_kind();
Kind command_line_kind();

} // namespace mesobridge::fuzz
