#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {
namespace {

/// The keys of one of the regions.
struct RegionTable {
  std::size_t index;

  template <class Member>
  Line operator()(std::string name, Member Scene::Region::*member, std::string meaning) const {
    Line line{"region", std::move(name),
              [index = index, member](Scene& scene) -> Slot {
                if (scene.regions.size() <= index) // of a scene that shows what a key takes
                  scene.regions.resize(index + 1);
                return &(scene.regions[index].*member);
              },
              std::move(meaning)};
    line.key.number = index + 1;
    return line;
  }
};

} // namespace

std::vector<SceneKey> region_keys(std::size_t index) {
  using Region = Scene::Region;
  RegionTable const region{index};
  return {
      region("name", &Region::name, "for people; if not given, region 1, region 2 ..."),
      region("shape", &Region::shape, "between two planes, a block, a sphere or a cylinder")
          .choices({"slab", "block", "sphere", "cylinder"})
          .required(),
      region("part", &Region::part, "inside the shape, or all of the box outside it")
          .choices({"inside", "outside"}),
      region("axis", &Region::axis, "across a slab, along a cylinder").choices({"x", "y", "z"}),
      region(
          "from", &Region::from,
          "where a slab or a cylinder begins along its axis, or the lower corner of a block; if not given, "
          "where the box does")
          .quantity(Dimension::length, any_number),
      region("to", &Region::to, "where it ends, or the upper corner; if not given, where the box does")
          .quantity(Dimension::length, any_number),
      region("centre", &Region::centre, "of a sphere or a cylinder; if not given, that of the box")
          .quantity(Dimension::length, any_number),
      region("radius", &Region::radius, "of a sphere or a cylinder").quantity(Dimension::length, positive),
      region("fill", &Region::fill, "fluid, or vacuum: no particles").choices({"fluid", "vacuum"}),
      region("lattice", &Region::lattice, "how particles stand at the start; random: anywhere")
          .choices({"cubic", "fcc", "random"}),
      region("eos", &Region::eos, "as fluid.eos; if not given, that one").of<sdpd::Sdpd>(),
      region("K", &Region::K, "molecules in one particle; if not given, particles.K")
          .in(sdpd::Sdpd::sizes)
          .of<sdpd::Sdpd>(),
      region("rho", &Region::rho, "mass per volume at the start; if not given, fluid.rho")
          .quantity(Dimension::density, positive),
      region("T", &Region::T, "temperature at the start; if not given, fluid.T")
          .quantity(Dimension::temperature, positive)
          .of<sdpd::Sdpd, sdpd::Dpde>(),
      region("progress", &Region::progress,
             "of the reaction at the start, 1 for products; if not given, reaction.progress")
          .in(sdpd::SdpdReaction::shares)
          .of<sdpd::Sdpd>(),
      region("velocity", &Region::velocity, "along x, y and z at the start; if not given, at rest")
          .quantity(Dimension::velocity, any_number),
      region("velocity_gradient", &Region::velocity_gradient,
             "how that velocity changes along the region's axis, where it is the velocity at the middle of "
             "the box")
          .quantity(Dimension::rate, any_number),
      region("mass", &Region::mass, "of one particle; if not given, particles.mass")
          .quantity(Dimension::mass, positive)
          .of<sdpd::Dpde, sdpd::Dpd>(),
      region("heat_capacity", &Region::heat_capacity,
             "of a particle, in k_B, constant; if not given, as [internal_energy] says")
          .in(positive)
          .of<sdpd::Dpde>(),
  };
}

std::vector<SceneKey> all_keys(Scene const& scene) {
  auto all = scene_keys();
  for (std::size_t k = 0; k < scene.regions.size(); ++k) {
    auto const of_region = region_keys(k);
    all.insert(all.end(), of_region.begin(), of_region.end());
  }
  return all;
}

} // namespace mesobridge::workflows
