#define OMPI_SKIP_MPICXX 1
#define LAMMPS_LIB_MPI
#include "md/lammps_session.hpp"
#include "md/ghost_cutoff.hpp"
#include "md/lammps_name.hpp"
#include <array>
#include <lammps/library.h>
#include <set>
#include <utility>

// Debian builds LAMMPS without exceptions: Error::all and its kin print the error and end the process. A
// definition in the program takes precedence over the one in the shared library, so the four ends of every
// error are defined here to throw instead. They stand in this file so that whoever uses LAMMPS links them.
// LAMMPS's own header does not compile with fmt 9; only the names and arguments matter to the linker.
namespace LAMMPS_NS {
class Error {
 public:
  [[noreturn]] void all(std::string const& file, int line, std::string const& text);
  [[noreturn]] void one(std::string const& file, int line, std::string const& text);
  [[noreturn]] void universe_all(std::string const& file, int line, std::string const& text);
  [[noreturn]] void universe_one(std::string const& file, int line, std::string const& text);
};
void Error::all(std::string const&, int, std::string const& text) {
  throw mesobridge::md::LammpsError(text);
}
void Error::one(std::string const&, int, std::string const& text) {
  throw mesobridge::md::LammpsError(text);
}
void Error::universe_all(std::string const&, int, std::string const& text) {
  throw mesobridge::md::LammpsError(text);
}
void Error::universe_one(std::string const&, int, std::string const& text) {
  throw mesobridge::md::LammpsError(text);
}
} // namespace LAMMPS_NS

namespace mesobridge::md {
namespace {

void* open_lammps(Ranks ranks) {
  std::array<std::string, 6> words{"mesobridge", "-screen", "none", "-log", "none", "-nocite"};
  std::array<char*, 6> arguments{};
  for (std::size_t k = 0; k < words.size(); ++k)
    arguments[k] = words[k].data();
  MPI_Comm const communicator = ranks == Ranks::own ? MPI_COMM_SELF : MPI_COMM_WORLD;
  void* const lammps = lammps_open(int(words.size()), arguments.data(), communicator, nullptr);
  if (!lammps)
    throw EnvironmentError("LAMMPS could not be started");
  return lammps;
}

/// A message as it would be if LAMMPS knew the file by its path.
std::string with_path(std::string message, std::string const& name, std::string const& path) {
  for (std::size_t at = 0; (at = message.find(name, at)) != std::string::npos; at += path.size())
    message.replace(at, name.size(), path);
  return message;
}

} // namespace

struct LammpsSession::Handle {
  void* lammps = nullptr;
  std::set<std::string> known_keywords;
  bool spent = false;
  std::function<void(ForcedAtoms const&)> add_forces; ///< LAMMPS calls it by way of this handle

  Handle() = default;
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  ~Handle() {
    // A spent session cannot be closed: it was left in the middle of what it did, with memory that it would
    // free twice, and of several ranks each may stand at another place. Its memory stays until the program
    // ends.
    if (lammps && !spent)
      lammps_close(lammps);
  }
};

template <class Call>
auto LammpsSession::guarded(std::string const& doing, Call&& call) {
  if (handle_->spent)
    throw LammpsError(fmt::format("LAMMPS was asked for '{}' after an error had ended its session", doing));
  try {
    return call(handle_->lammps);
  } catch (LammpsError const& error) {
    handle_->spent = true;
    throw LammpsError(fmt::format("LAMMPS: {} (at '{}')", error.what(), doing));
  }
}

LammpsSession::LammpsSession(MpiWorld const&, Ranks ranks, std::filesystem::path const& log_file, Log log)
    : handle_(std::make_unique<Handle>()) {
  guarded("start", [&](void*) { handle_->lammps = open_lammps(ranks); });
  if (!log_file.empty())
    command_with_file("log", log_file, log == Log::append ? "append" : "");
}

LammpsSession::~LammpsSession() = default;
LammpsSession::LammpsSession(LammpsSession&&) noexcept = default;
LammpsSession& LammpsSession::operator=(LammpsSession&&) noexcept = default;

void LammpsSession::command(std::string const& text) {
  guarded(text, [&](void* lammps) { lammps_command(lammps, text.c_str()); });
}

void LammpsSession::command_with_file(std::string const& words, std::filesystem::path const& file,
                                      std::string const& more) {
  LammpsName const name(file);
  try {
    command(fmt::format("{} \"{}\"{}{}", words, name.text(), more.empty() ? "" : " ", more));
  } catch (LammpsError const& error) {
    throw LammpsError(with_path(error.what(), name.text(), file.string()));
  }
}

double LammpsSession::thermo(std::string const& keyword) {
  // The library answers an unknown keyword with a zero; a variable made of it is an error.
  if (!handle_->known_keywords.contains(keyword)) {
    command("variable mesobridge_keyword equal {}", keyword);
    guarded("thermo keyword " + keyword, [](void* lammps) {
      lammps_free(lammps_extract_variable(lammps, "mesobridge_keyword", nullptr));
    });
    command("variable mesobridge_keyword delete");
    handle_->known_keywords.insert(keyword);
  }
  return guarded("thermo keyword " + keyword,
                 [&](void* lammps) { return lammps_get_thermo(lammps, keyword.c_str()); });
}

double LammpsSession::compute(std::string const& id) {
  return guarded("compute " + id, [&](void* lammps) {
    auto const* value = static_cast<double const*>(
        lammps_extract_compute(lammps, id.c_str(), LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR));
    require(value != nullptr, "LAMMPS compute", id, "no compute with this id has a global scalar");
    return *value;
  });
}

double LammpsSession::compute(std::string const& id, int component) {
  return guarded("compute " + id, [&](void* lammps) {
    auto const* size = static_cast<int const*>(
        lammps_extract_compute(lammps, id.c_str(), LMP_STYLE_GLOBAL, LMP_SIZE_VECTOR));
    require(size != nullptr, "LAMMPS compute", id, "no compute with this id has a global vector");
    require(component >= 0 && component < *size, "component of a LAMMPS compute", component,
            fmt::format("'{}' has {}", id, *size));
    return static_cast<double const*>(
        lammps_extract_compute(lammps, id.c_str(), LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR))[component];
  });
}

double LammpsSession::reach() {
  return guarded("look at the cut-offs", [](void* lammps) { return ghost_cutoff(lammps); });
}

void* LammpsSession::lammps() const {
  return handle_->lammps;
}

UnitConstants LammpsSession::unit_constants() const {
  auto const value = [&](char const* name) {
    return *static_cast<double const*>(lammps_extract_global(handle_->lammps, name));
  };
  return {.boltzmann = value("boltz"), .energy_of_mv2 = value("mvv2e"), .pressure_of_nkt = value("nktv2p")};
}

std::int64_t LammpsSession::atoms() const {
  return std::int64_t(lammps_get_natoms(handle_->lammps));
}

std::int64_t LammpsSession::step() const {
  return *static_cast<std::int64_t const*>(lammps_extract_global(handle_->lammps, "ntimestep"));
}

Frame LammpsSession::frame() {
  return guarded("gather atoms", [&](void* lammps) {
    std::array<double, 3> low{}, high{};
    double xy = 0, yz = 0, xz = 0;
    lammps_extract_box(lammps, low.data(), high.data(), &xy, &yz, &xz, nullptr, nullptr);
    require(xy == 0 && yz == 0 && xz == 0, "tilt of the LAMMPS box", xy,
            "must be 0: only rectangular boxes are read");

    auto const n = std::size_t(lammps_get_natoms(lammps));
    Frame frame{.step = *static_cast<std::int64_t const*>(lammps_extract_global(lammps, "ntimestep")),
                .box = {{high[0] - low[0], high[1] - low[1], high[2] - low[2]}},
                .positions = std::vector<Vec3>(n),
                .velocities = std::vector<Vec3>(n),
                .types = std::vector<int>(n)};
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    std::string x = "x", v = "v", type = "type"; // LAMMPS asks for names that it may write to
    lammps_gather_atoms(lammps, x.data(), 1, 3, frame.positions.data());
    lammps_gather_atoms(lammps, v.data(), 1, 3, frame.velocities.data());
    lammps_gather_atoms(lammps, type.data(), 0, 1, frame.types.data());
    for (Vec3& q : frame.positions)
      q = frame.box.wrap(q - Vec3{low[0], low[1], low[2]});
    return frame;
  });
}

OwnedAtoms LammpsSession::owned_atoms(std::string const& energy_compute) {
  return guarded("read the atoms", [&](void* lammps) {
    auto const n = std::size_t(lammps_extract_setting(lammps, "nlocal"));
    auto const* const ids = static_cast<int const*>(lammps_extract_atom(lammps, "id"));
    auto const vectors = [&](char const* name) {
      auto const* const* const rows = static_cast<double const* const*>(lammps_extract_atom(lammps, name));
      std::vector<Vec3> result(n);
      for (std::size_t i = 0; i < n; ++i)
        result[i] = {rows[i][0], rows[i][1], rows[i][2]};
      return result;
    };
    OwnedAtoms atoms{
        .ids = {ids, ids + n}, .q = vectors("x"), .v = vectors("v"), .f = vectors("f"), .potential = {}};
    if (!energy_compute.empty()) {
      auto const* const energies = static_cast<double const*>(
          lammps_extract_compute(lammps, energy_compute.c_str(), LMP_STYLE_ATOM, LMP_TYPE_VECTOR));
      require(energies != nullptr || n == 0, "LAMMPS compute", energy_compute,
              "no compute with this id has a number for each atom");
      atoms.potential.assign(energies, energies + n);
    }
    return atoms;
  });
}

void LammpsSession::set_velocities(
    std::function<Vec3(std::int64_t id, Vec3 const& velocity)> const& velocity_of) {
  guarded("set velocities", [&](void* lammps) {
    int const n = lammps_extract_setting(lammps, "nlocal");
    auto const* const ids = static_cast<int const*>(lammps_extract_atom(lammps, "id"));
    auto* const* const v = static_cast<double* const*>(lammps_extract_atom(lammps, "v"));
    for (int i = 0; i < n; ++i) {
      Vec3 const now = velocity_of(ids[i], {v[i][0], v[i][1], v[i][2]});
      v[i][0] = now.x, v[i][1] = now.y, v[i][2] = now.z;
    }
  });
}

namespace {

/// What LAMMPS calls: the handle, the step, the number of this rank's atoms, their ids, places, and forces to
/// be filled in.
template <class Handle>
void call_back(void* pointer, std::int64_t, int n, int* ids, double**, double** added) {
  auto& handle = *static_cast<Handle*>(pointer);
  auto const* const* const f = static_cast<double const* const*>(lammps_extract_atom(handle.lammps, "f"));
  handle.add_forces({.ids = {ids, std::size_t(n)}, .f = f, .added = added});
}

} // namespace

void LammpsSession::add_forces(std::function<void(ForcedAtoms const&)> add) {
  handle_->add_forces = std::move(add);
  command("fix mesobridge_forces all external pf/callback 1 1");
  command("fix_modify mesobridge_forces energy no virial no");
  guarded("set the forces' callback", [&](void* lammps) {
    lammps_set_fix_external_callback(lammps, "mesobridge_forces", call_back<Handle>, handle_.get());
  });
}

void LammpsSession::set_positions(std::function<Vec3(std::int64_t id)> const& position_of) {
  guarded("set positions", [&](void* lammps) {
    int const n = lammps_extract_setting(lammps, "nlocal");
    auto const* const ids = static_cast<int const*>(lammps_extract_atom(lammps, "id"));
    auto* const* const x = static_cast<double* const*>(lammps_extract_atom(lammps, "x"));
    for (int i = 0; i < n; ++i) {
      Vec3 const q = position_of(ids[i]);
      x[i][0] = q.x, x[i][1] = q.y, x[i][2] = q.z;
    }
  });
}

bool LammpsSession::has_style(std::string const& category, std::string const& name) const {
  return lammps_has_style(handle_->lammps, category.c_str(), name.c_str()) != 0;
}

LammpsInstallation lammps_installation(MpiWorld const&) {
  LammpsInstallation found;
  std::array<char, 128> name{};
  for (int k = 0; k < lammps_config_package_count(); ++k)
    if (lammps_config_package_name(k, name.data(), int(name.size())))
      found.packages.emplace_back(name.data());
  void* const lammps = open_lammps(Ranks::own);
  found.version = lammps_version(lammps);
  lammps_close(lammps);
  return found;
}

} // namespace mesobridge::md
