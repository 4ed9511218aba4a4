#pragma once
#include "sdpd/method/list.hpp"
#include "workflows/scene/scene.hpp"

namespace mesobridge::workflows {

/// The method that a scene names, with what its tables, models and keys say of it. Throws InputError.
sdpd::AnyMethod method_of(Scene const& scene);

} // namespace mesobridge::workflows
