#pragma once
#include "md/lj_fluid.hpp"
#include <string_view>

namespace mesobridge::workflows {

/// The preset of a name that the command line has checked: "quick", "standard" or "paper".
inline md::Preset preset_of(std::string_view name) {
  return name == "quick" ? md::Preset::quick : name == "standard" ? md::Preset::standard : md::Preset::paper;
}

/// And its name.
inline char const* name_of(md::Preset preset) {
  return preset == md::Preset::quick ? "quick" : preset == md::Preset::standard ? "standard" : "paper";
}

} // namespace mesobridge::workflows
