#include "workflows/sdpd/layout_of.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// What the particles of a region are.
struct Material {
  std::string eos;
  double K, mass, heat_capacity;

  bool operator==(Material const&) const = default;
};

Material material_of(Scene const& scene) {
  return {scene.fluid.eos, scene.particles.K, scene.particles.mass.value_or(0),
          scene.internal_energy.heat_capacity.value_or(0)};
}

Material material_of(Scene const& scene, Scene::Region const& region) {
  auto const base = material_of(scene);
  return {region.eos.value_or(base.eos), region.K.value_or(base.K), region.mass.value_or(base.mass),
          region.heat_capacity.value_or(base.heat_capacity)};
}

/// The scene's regions on their way into the engine's units.
class Plan {
 public:
  Plan(Scene const& scene, sdpd::SimulationSettings const& settings)
      : scene_(scene), settings_(settings), units_(settings.units()), edge_(edge_of_box()) {
    add({.name = "fluid", .shape = sdpd::Cuboid{{}, edge_}, .progress = scene.reaction.progress},
        material_of(scene), scene.fluid.rho, scene.fluid.T);
    for (std::size_t k = 0; k < scene.regions.size(); ++k)
      add(scene.regions[k], k);
  }

  std::vector<Material> const& materials() const { return materials_; }
  std::vector<sdpd::Region> const& regions() const { return regions_; }
  Vec3 const& edge() const { return edge_; }
  /// The state in which a material begins: rho and T.
  std::pair<double, double> state_of(std::size_t material) const { return states_[material]; }

 private:
  Vec3 edge_of_box() const {
    if (scene_.box.size.empty())
      return sdpd::box_of(settings_).edge;
    auto const& size = scene_.box.size;
    return Vec3{size[0], size[1], size[2]} / units_.length();
  }

  void add(sdpd::Region region, Material const& material, double rho, double T) {
    auto const found = std::ranges::find(materials_, material);
    region.species = static_cast<std::uint32_t>(found - materials_.begin());
    if (found == materials_.end())
      materials_.push_back(material), states_.emplace_back(rho, T);
    region.spacing = std::cbrt(mass_of(material) / rho) / units_.length();
    region.T = T / units_.temperature;
    regions_.push_back(std::move(region));
  }

  void add(Scene::Region const& of, std::size_t k) {
    double const v = units_.velocity(), rate = 1 / units_.time();
    sdpd::Region region{.name = of.name.empty() ? fmt::format("region {}", k + 1) : of.name,
                        .shape = shape_of(of, k),
                        .outside = of.part == "outside",
                        .vacuum = of.fill == "vacuum",
                        .lattice = of.lattice == "fcc"      ? sdpd::Lattice::fcc
                                   : of.lattice == "random" ? sdpd::Lattice::random
                                                            : sdpd::Lattice::cubic,
                        .progress = of.progress.value_or(scene_.reaction.progress),
                        .velocity = vector_of(of.velocity) / v};
    Vec3 const gradient = vector_of(of.velocity_gradient) / rate;
    (of.axis == "x" ? region.along_x : of.axis == "y" ? region.along_y : region.along_z) = gradient;
    double const rho = of.rho.value_or(scene_.fluid.rho), T = of.T.value_or(scene_.fluid.T);
    if (of.fill == "fluid" && scene_.features().densities && region.progress <= 0)
      check_state(material_of(scene_, of).eos, rho, T, k);
    if (of.fill == "fluid" && region.progress >= 1)
      check_state(*scene_.reaction.product, rho, T, k);
    add(std::move(region), material_of(scene_, of), rho, T);
  }

  /// The model must have the state that a region begins with.
  void check_state(std::string const& eos, double rho, double T, std::size_t k) const {
    Scene scene = scene_;
    scene.fluid.eos = eos;
    try {
      std::visit([&](auto const& of) { of.energy_from_temperature(T, rho); }, eos_of(scene));
    } catch (PhysicsError const& error) {
      throw InputError(fmt::format("region.{}.rho = {:g} at T = {:g}: {}", k + 1, rho, T, error.what()));
    }
  }

  static Vec3 vector_of(std::vector<double> const& numbers) {
    return numbers.empty() ? Vec3{} : Vec3{numbers[0], numbers[1], numbers[2]};
  }

  double mass_of(Material const& material) const {
    if (!scene_.features().densities)
      return material.mass;
    Scene scene = scene_;
    scene.fluid.eos = material.eos;
    return material.K * std::visit([](auto const& eos) { return eos.molecular_mass(); }, eos_of(scene));
  }

  /// In the engine's length, along an axis whose edge is known.
  double place(Coordinate const& at, int axis) const {
    return at.of(component(edge_, axis) * units_.length()) / units_.length();
  }
  /// Three places, or the one that is given for `only`; what is not given stays.
  Vec3 places(std::vector<Coordinate> const& given, int only, Vec3 at) const {
    for (int axis = 0; axis < 3; ++axis)
      if (given.size() == 3)
        component(at, axis) = place(given[static_cast<std::size_t>(axis)], axis);
      else if (given.size() == 1 && axis == only)
        component(at, axis) = place(given[0], axis);
    return at;
  }

  sdpd::Shape shape_of(Scene::Region const& of, std::size_t k) const {
    int const axis = of.axis[0] - 'x';
    Vec3 const from = places(of.from, axis, {}), to = places(of.to, axis, edge_),
               centre = places(of.centre, axis, 0.5 * edge_);
    for (int a = 0; a < 3; ++a)
      require(component(from, a) < component(to, a), fmt::format("region.{}.to", k + 1),
              component(to, a) * units_.length(),
              fmt::format("must be > {}, where the region begins", component(from, a) * units_.length()));
    if (of.shape == "sphere")
      return sdpd::Sphere{centre, *of.radius / units_.length()};
    if (of.shape == "cylinder")
      return sdpd::Cylinder{axis, centre, *of.radius / units_.length(), component(from, axis),
                            component(to, axis)};
    return sdpd::Cuboid{from, to};
  }

  Scene const& scene_;
  sdpd::SimulationSettings const& settings_;
  sdpd::ReducedUnits units_;
  Vec3 edge_;
  std::vector<Material> materials_;
  std::vector<std::pair<double, double>> states_;
  std::vector<sdpd::Region> regions_;
};

/// Regions of the same distance between particles have a smooth number density, whatever their masses.
sdpd::DensitySum density_sum_of(Scene const& scene, std::vector<sdpd::Region> const& regions) {
  auto const& asked = scene.particles.density_sum;
  if (asked != "auto")
    return asked == "number" ? sdpd::DensitySum::number : sdpd::DensitySum::mass;
  constexpr double alike = 1e-3;
  bool const same = std::ranges::all_of(regions, [&](sdpd::Region const& region) {
    return region.vacuum || std::abs(region.spacing / regions.front().spacing - 1) < alike;
  });
  return same ? sdpd::DensitySum::number : sdpd::DensitySum::mass;
}

void set_species(sdpd::Sdpd& fluid, Scene const& scene, Plan const& plan) {
  fluid.density_sum = density_sum_of(scene, plan.regions());
  for (std::size_t k = 0; k < plan.materials().size(); ++k) {
    auto const& of = plan.materials()[k];
    Scene one = scene;
    one.fluid.eos = of.eos;
    auto const [rho, T] = plan.state_of(k);
    fluid.species.push_back({.name = of.eos, .share = 0, .K = of.K, .eos = eos_of(one), .rho = rho, .T = T});
  }
}

void set_species(sdpd::Dpde& fluid, Scene const&, Plan const& plan) {
  for (auto const& of : plan.materials())
    fluid.species.push_back(
        {"", 0, of.mass,
         of.heat_capacity > 0 ? fitting::ConstantHeatCapacity(of.heat_capacity) : fluid.internal_energy});
}

void set_species(sdpd::Dpd& fluid, Scene const&, Plan const& plan) {
  for (auto const& of : plan.materials())
    fluid.species.push_back({"", 0, of.mass});
}

} // namespace

bool has_layout(Scene const& scene) {
  return !scene.regions.empty() || !scene.box.size.empty();
}

namespace {

/// Refusals of the engine name the key that asked for the layout.
std::shared_ptr<sdpd::Layout const> make_layout(Scene const& scene, Plan const& plan, std::uint64_t seed) {
  try {
    return std::make_shared<sdpd::Layout const>(plan.edge(), plan.regions(), seed);
  } catch (InputError const& error) {
    auto const count = scene.regions.size();
    throw InputError(count == 0 ? fmt::format("particles.K = {}: {}", scene.particles.K, error.what())
                                : fmt::format("region.{}.shape = {}: {}", count, scene.regions.back().shape,
                                              error.what()));
  }
}

} // namespace

void lay_out(Scene const& scene, sdpd::SimulationSettings& settings) {
  Plan const plan(scene, settings);
  settings.layout = make_layout(scene, plan, settings.seed);
  if (plan.materials().size() > 1)
    std::visit([&](auto& method) { set_species(method, scene, plan); }, settings.method);
}

} // namespace mesobridge::workflows
