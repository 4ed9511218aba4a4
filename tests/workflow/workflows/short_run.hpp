#pragma once
#include "workflows/process.hpp"
#include "workflows/store/hdf5_handle.hpp"
#include "workflows/text_file.hpp"
#include <map>
#include <stdexcept>

namespace mesobridge::tests {

/// A run of a tenth of a second with all outputs there are, and what it leaves behind.
class ShortRun {
 public:
  /// `tools` is a directory that gets a stand-in for gnuplot, which would take longer than the run.
  explicit ShortRun(std::filesystem::path const& tools) : tools_(tools) {
    std::filesystem::create_directories(tools);
    auto const gnuplot = tools / "gnuplot";
    workflows::write_text_file(gnuplot, "#!/bin/sh\ncat >/dev/null\nprintf '<svg></svg>\\n\\n'\n");
    std::filesystem::permissions(gnuplot, std::filesystem::perms::owner_all);
  }

  /// Runs in a directory, under variables of the environment ("NAME=value").
  workflows::ProcessResult operator()(std::filesystem::path const& directory, bool resume,
                                      std::vector<std::string> const& environment = {}) const {
    std::vector<std::string> words{"timeout", "-k",  "1",
                                   "20",      "env", "PATH=" + tools_.string() + ":/usr/bin:/bin"};
    words.insert(words.end(), environment.begin(), environment.end());
    words.insert(words.end(),
                 {MESOBRIDGE_PROGRAM, "run", MESOBRIDGE_SOURCE_DIR "/workflows/scenes/ideal-gas.toml", "-o",
                  directory.string(), "--quiet", "--threads", "1"});
    for (char const* set : {"particles.N=343", "run.equilibrate=4", "run.steps=64", "run.sample_every=2",
                            "run.trajectory_every=16", "run.vtkhdf_every=32", "run.xyz_every=16",
                            "profile.every=16", "histogram.every=32", "run.checkpoint_every=24"})
      words.insert(words.end(), {"--set", set});
    if (resume)
      words.emplace_back("--resume");
    return workflows::run_process(words);
  }

  /// All numbers and texts of a run's results, by file and dataset. Throws when one cannot be read.
  static std::map<std::string, std::string> content(std::filesystem::path const& directory) {
    std::map<std::string, std::string> all;
    for (char const* name : {"run.h5", "trajectory.h5md", "trajectory.vtkhdf"})
      add_datasets(directory / name, name, all);
    for (char const* name : {"trajectory.xyz", "summary.json", "scene.toml"})
      all[name] = workflows::read_text_file(directory / name);
    return all;
  }

 private:
  struct Visit {
    hid_t file;
    std::string prefix;
    std::map<std::string, std::string>* all;
    bool failed = false;
  };

  static herr_t visit(hid_t, char const* name, H5O_info_t const* info, void* data) {
    auto& v = *static_cast<Visit*>(data);
    // The provenance holds the command line, which says where the run is.
    if (info->type != H5O_TYPE_DATASET || std::string(name).starts_with("provenance"))
      return 0;
    workflows::Hdf5Handle const set(H5Dopen2(v.file, name, H5P_DEFAULT), H5Dclose);
    workflows::Hdf5Handle const type(H5Dget_type(set.get()), H5Tclose),
        space(H5Dget_space(set.get()), H5Sclose);
    auto& text = (*v.all)[v.prefix + ":" + name];
    text.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get())) *
                H5Tget_size(type.get()));
    if (H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0)
      v.failed = true;
    return 0;
  }

  static void add_datasets(std::filesystem::path const& path, std::string const& name,
                           std::map<std::string, std::string>& all) {
    workflows::prepare_hdf5();
    workflows::Hdf5Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    Visit v{file.get(), name, &all};
    if (!file.valid() || H5Ovisit(file.get(), H5_INDEX_NAME, H5_ITER_INC, visit, &v) < 0 || v.failed)
      throw std::runtime_error("cannot read " + path.string());
  }

  std::filesystem::path tools_;
};

} // namespace mesobridge::tests
