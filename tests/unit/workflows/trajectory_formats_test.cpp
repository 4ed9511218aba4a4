#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/extended_xyz.hpp"
#include "workflows/h5md.hpp"
#include "workflows/paraview_series.hpp"
#include "workflows/store/seal.hpp"
#include "workflows/text_file.hpp"
#include "workflows/vtkhdf.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

constexpr std::size_t particles = 3;

/// Frame `number` of a trajectory in which every number tells where it belongs.
ParticleFrame frame(std::int64_t number) {
  ParticleFrame of{.step = 10 * number,
                   .time = 0.5 * static_cast<double>(number),
                   .box = {{4, 5, 6}},
                   .positions = {},
                   .velocities = {},
                   .scalars = {{"T_K", {}}, {"rho", {}}}};
  for (std::size_t i = 0; i < particles; ++i) {
    double const label = 100.0 * static_cast<double>(number) + static_cast<double>(i) + 1.0 / 3;
    of.positions.push_back({label, label + 10, label + 20});
    of.velocities.push_back({-label, -label - 10, -label - 20});
    of.scalars[0].second.push_back(2 * label);
    of.scalars[1].second.push_back(3 * label);
  }
  return of;
}

/// One step of a VTKHDF file as the specification says that a reader finds it.
struct VtkStep {
  std::vector<double> points, velocity, T;
  std::vector<std::int64_t> id, connectivity, offsets;
};

template <class T>
std::vector<T> part(std::vector<T> const& all, std::int64_t begin, std::int64_t count,
                    std::int64_t width = 1) {
  return {all.begin() + begin * width, all.begin() + (begin + count) * width};
}

VtkStep read_step(Store const& store, std::size_t k) {
  auto steps = [&](std::string const& name) { return store.read_integers("VTKHDF/Steps/" + name).at(k); };
  auto count = [&](std::string const& name) {
    return store.read_integers("VTKHDF/" + name).at(static_cast<std::size_t>(steps("PartOffsets")));
  };
  std::int64_t const n = count("NumberOfPoints"), cells = count("NumberOfCells");
  EXPECT_EQ(steps("NumberOfParts"), 1);
  return {.points = part(store.read_doubles("VTKHDF/Points"), steps("PointOffsets"), n, 3),
          .velocity =
              part(store.read_doubles("VTKHDF/PointData/velocity"), steps("PointDataOffsets/velocity"), n, 3),
          .T = part(store.read_doubles("VTKHDF/PointData/T_K"), steps("PointDataOffsets/T_K"), n),
          .id = part(store.read_integers("VTKHDF/PointData/id"), steps("PointDataOffsets/id"), n),
          .connectivity = part(store.read_integers("VTKHDF/Connectivity"), steps("ConnectivityIdOffsets"),
                               count("NumberOfConnectivityIds")),
          .offsets = part(store.read_integers("VTKHDF/Offsets"), steps("CellOffsets"), cells + 1)};
}

TEST(VtkHdf, EveryStepIsFoundByTheOffsetsOfTheFormat) {
  ScratchDirectory const scratch;
  auto const file = scratch / "t.vtkhdf";
  {
    VtkHdfWriter writer(file, {});
    writer.append(frame(0));
    writer.append(frame(1));
    writer.close();
  }
  {
    auto writer = VtkHdfWriter::continue_file(file);
    EXPECT_EQ(writer.last_step(), 10);
    writer.append(frame(2));
    writer.close();
  }
  Store const store(file, Store::Mode::read);
  ASSERT_EQ(store.read_integer_attribute("VTKHDF/Steps", "NSteps"), 3);
  EXPECT_EQ(store.read_doubles("VTKHDF/Steps/Values"), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(store.read_integers("VTKHDF/Types"), std::vector<std::int64_t>(particles, 1)); // VTK_VERTEX
  for (std::size_t k = 0; k < 3; ++k) {
    auto const expected = frame(static_cast<std::int64_t>(k));
    auto const step = read_step(store, k);
    EXPECT_EQ(step.offsets, (std::vector<std::int64_t>{0, 1, 2, 3}));
    EXPECT_EQ(step.connectivity, (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(step.id, (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(step.T, expected.scalars[0].second);
    for (std::size_t i = 0; i < particles; ++i) {
      EXPECT_EQ(step.points[3 * i + 1], expected.positions[i].y);
      EXPECT_EQ(step.velocity[3 * i + 2], expected.velocities[i].z);
    }
  }
}

/// ParaView 5.11 reads version 1 of the format, one file a time.
TEST(VtkHdf, EveryFrameIsShownByAFileOfItsOwn) {
  ScratchDirectory const scratch;
  std::filesystem::create_directory(scratch / "a run");
  {
    VtkHdfWriter writer(scratch / "a run" / "t.vtkhdf", {});
    for (std::int64_t k : {0, 1, 2})
      writer.append(frame(k));
    writer.close();
  }
  write_paraview_series(scratch / "a run" / "t.vtkhdf");
  std::filesystem::rename(scratch / "a run", scratch / "moved"); // both keep their places to each other
  auto const series = Json::parse(read_text_file(scratch / "moved" / "t.hdf.series"));
  ASSERT_EQ(series["files"].size(), 3u);
  for (std::int64_t k : {0, 1, 2}) {
    auto const expected = frame(k);
    auto const& entry = series["files"][static_cast<std::size_t>(k)];
    EXPECT_EQ(entry["time"], expected.time);
    Store const shown(scratch / "moved" / entry["name"].get<std::string>(), Store::Mode::read);
    EXPECT_EQ(shown.read_integers("VTKHDF/NumberOfPoints"), std::vector<std::int64_t>{particles});
    EXPECT_EQ(shown.read_integers("VTKHDF/Offsets"), (std::vector<std::int64_t>{0, 1, 2, 3}));
    EXPECT_EQ(shown.read_doubles("VTKHDF/PointData/T_K"), expected.scalars[0].second);
    auto const points = shown.read_doubles("VTKHDF/Points");
    for (std::size_t i = 0; i < particles; ++i)
      EXPECT_EQ(points.at(3 * i + 1), expected.positions[i].y);
  }
}

TEST(VtkHdf, RefusesWhatIsNotANumberAndWhatIsNoVtkHdf) {
  ScratchDirectory const scratch;
  auto bad = frame(0);
  bad.scalars[1].second[2] = std::nan("");
  VtkHdfWriter writer(scratch / "t.vtkhdf", {});
  EXPECT_THROW(writer.append(bad), PhysicsError);
  EXPECT_EQ(writer.last_step(), -1);
  Store(scratch / "other.h5", Store::Mode::create).close();
  EXPECT_THROW(VtkHdfWriter::continue_file(scratch / "other.h5"), InputError);
}

TEST(ExtendedXyz, NumbersReadBackAsTheSameBits) {
  ScratchDirectory const scratch;
  ExtendedXyzWriter writer(scratch / "t.xyz");
  writer.append(frame(7));
  std::istringstream text(read_text_file(scratch / "t.xyz"));
  std::string count, header;
  std::getline(text, count), std::getline(text, header);
  EXPECT_EQ(count, "3");
  EXPECT_EQ(
      header,
      "Lattice=\"4 0 0 0 5 0 0 0 6\" Properties=species:S:1:id:I:1:pos:R:3:velo:R:3:T_K:R:1:rho:R:1 step=70 "
      "time=3.5 pbc=\"T T T\"");
  auto const expected = frame(7);
  std::size_t read = 0;
  std::string species;
  double id, x, y, z, u, v, w, T, rho;
  while (text >> species >> id >> x >> y >> z >> u >> v >> w >> T >> rho) {
    EXPECT_EQ(species, "X");
    EXPECT_EQ(id, static_cast<double>(read));
    EXPECT_EQ(y, expected.positions[read].y);
    EXPECT_EQ(w, expected.velocities[read].z);
    EXPECT_EQ(rho, expected.scalars[1].second[read]);
    ++read;
  }
  EXPECT_EQ(read, particles);
}

TEST(ExtendedXyz, IsInAngstromWhereFramesAreInNanometres) {
  ScratchDirectory const scratch;
  auto of = frame(7);
  of.to_angstrom = 10;
  ExtendedXyzWriter writer(scratch / "t.xyz");
  writer.append(of);
  auto const text = read_text_file(scratch / "t.xyz");
  EXPECT_NE(text.find("Lattice=\"40 0 0 0 50 0 0 0 60\""), std::string::npos);
  EXPECT_NE(text.find(fmt::format("\nX 1 {} ", 10 * of.positions[1].x)), std::string::npos);
  EXPECT_NE(text.find(fmt::format(" {} {} {}\n", 10 * of.velocities[1].z, of.scalars[0].second[1],
                                  of.scalars[1].second[1])),
            std::string::npos);
}

TEST(ExtendedXyz, DoesNotGoOnWithFramesOfOtherColumns) {
  ScratchDirectory const scratch;
  auto const file = scratch / "t.xyz";
  write_text_file(
      file, "1\nLattice=\"1 0 0 0 1 0 0 0 1\" Properties=id:I:1:pos:R:3:velo:R:3 step=5 time=0 pbc=\"T T "
            "T\"\n0 0 0 0 0 0 0\n");
  auto writer = ExtendedXyzWriter::continue_file(file);
  EXPECT_EQ(writer.last_step(), 5);
  EXPECT_THROW(writer.append(frame(7)), InputError);
}

TEST(H5md, HoldsWhatParticlesHaveWithItsUnit) {
  ScratchDirectory const scratch;
  auto const file = scratch / "t.h5md";
  auto const of = frame(7);
  H5mdWriter writer(file, H5mdWriter::Units::si(), {});
  for (std::int64_t const step : {0, 1})
    writer.append({.step = step, .time = 0, .box = of.box, .positions = of.positions, .scalars = of.scalars});
  writer.close();
  Store const store(file, Store::Mode::read);
  EXPECT_EQ(store.read_text_attribute("particles/trajectory/T/value", "unit"), "K");
  EXPECT_EQ(store.read_row("particles/trajectory/T/value", 1), of.scalars[0].second);
  EXPECT_EQ(store.read_row("particles/trajectory/rho/value", 0), of.scalars[1].second);
  EXPECT_EQ(store.rows("particles/trajectory/rho/step"), 2u);
  EXPECT_EQ(store.read_row("observables/T/value", 1), of.scalars[0].second);
}

// Edges that end at walls or vacuum are not periodic for whoever reads the file.
TEST(Trajectories, SayWhichEdgesArePeriodic) {
  ScratchDirectory const scratch;
  auto open = frame(0);
  open.box.periodic = {true, false, true};
  ExtendedXyzWriter xyz(scratch / "t.xyz");
  xyz.append(open);
  xyz.close();
  EXPECT_NE(read_text_file(scratch / "t.xyz").find("pbc=\"T F T\""), std::string::npos);
  H5mdWriter(scratch / "t.h5", H5mdWriter::Units::si(), {}, open.box.periodic).close();
  EXPECT_EQ(
      Store(scratch / "t.h5", Store::Mode::read).read_text_attributes("particles/trajectory/box", "boundary"),
      (std::vector<std::string>{"periodic", "none", "periodic"}));
}

TEST(ExtendedXyz, GoesOnAfterTheLastWholeFrame) {
  ScratchDirectory const scratch;
  ExtendedXyzWriter whole(scratch / "whole.xyz");
  for (std::int64_t const k : {0, 1, 2})
    whole.append(frame(k));
  auto const text = read_text_file(scratch / "whole.xyz");
  std::size_t cuts = 0;
  for (std::size_t const lost : {1u, 2u, 40u, 200u, 400u}) { // within the last frame, and in the one before
    auto const file = scratch / "broken.xyz";                // of a version that did not seal it
    remove_seal_beside(file);
    write_text_file(file, text.substr(0, text.size() - lost));
    auto writer = ExtendedXyzWriter::continue_file(file);
    for (auto next = writer.last_step() / 10 + 1; next < 3; ++next, ++cuts)
      writer.append(frame(next));
    writer.close();
    EXPECT_EQ(read_text_file(file), text) << lost;
  }
  EXPECT_GE(cuts, 5u);
  write_text_file(scratch / "foreign.xyz", "1\nno step here\nAr 0 0 0\n");
  EXPECT_THROW(ExtendedXyzWriter::continue_file(scratch / "foreign.xyz"), InputError);
}

/// A file of three frames that was closed, and what may become of it until a run goes on with it.
TEST(ExtendedXyz, RefusesAClosedFileThatIsNotWhatItWas) {
  ScratchDirectory const scratch;
  auto const file = scratch / "t.xyz", seal = scratch / "t.xyz.seal";
  ExtendedXyzWriter whole(file);
  for (std::int64_t const k : {0, 1, 2})
    whole.append(frame(k));
  whole.close();
  auto const text = read_text_file(file), sealed = read_text_file(seal);
  auto const third = text.rfind("\n3\n") + 1; // where the last frame begins: its number of particles
  ASSERT_GT(third, 100u);
  auto digit = text, number = text, repeated = text + text.substr(third), padded = text + "\n";
  digit[text.find('.', 200) + 1] = digit[text.find('.', 200) + 1] == '5' ? '6' : '5';
  number.replace(text.find("step="), 6, "step=9");
  std::vector<std::pair<std::string, std::string>> const damages{
      {"a digit", digit},
      {"another step", number},
      {"the last frame is missing", text.substr(0, third)},
      {"the first frame is missing", text.substr(text.find("\n3\n") + 1)},
      {"cut within a frame", text.substr(0, text.size() - 40)},
      {"a frame twice", repeated},
      {"an empty line more", padded},
      {"empty", ""}};
  int refused = 0;
  for (auto const& [how, content] : damages) {
    write_text_file(file, content);
    EXPECT_THROW(ExtendedXyzWriter::continue_file(file), InputError) << how;
    EXPECT_EQ(read_text_file(file), content) << how; // left as it was found
    ++refused;
  }
  EXPECT_EQ(refused, 8);
  write_text_file(file, text);
  for (auto const& broken :
       {std::string(), sealed.substr(1), sealed + "x", std::string(sealed.size(), '\0')}) {
    write_text_file(seal, broken);
    EXPECT_THROW(ExtendedXyzWriter::continue_file(file), InputError);
  }
  write_text_file(seal, sealed);
  auto writer = ExtendedXyzWriter::continue_file(file);
  EXPECT_EQ(writer.last_step(), 20);
  EXPECT_FALSE(std::filesystem::exists(seal)); // it may change from here on
}

// A process that dies while it closes the file, once the seal is there, has the journal beside it still.
TEST(ExtendedXyz, GoesOnWhenSealAndJournalAreThere) {
  ScratchDirectory const scratch;
  auto const file = scratch / "t.xyz";
  {
    ExtendedXyzWriter writer(file);
    writer.append(frame(0)), writer.mark(), writer.append(frame(1)), writer.mark();
    seal_beside(file);
    writer.append(frame(2)); // after the seal, and not marked
  }
  ASSERT_TRUE(UndoJournal::exists(file));
  auto again = ExtendedXyzWriter::continue_file(file);
  EXPECT_EQ(again.last_step(), 10);
  again.append(frame(2)), again.close();
  ExtendedXyzWriter unbroken(scratch / "whole.xyz");
  for (std::int64_t const k : {0, 1, 2})
    unbroken.append(frame(k));
  unbroken.close();
  EXPECT_EQ(read_text_file(file), read_text_file(scratch / "whole.xyz"));
}

} // namespace
} // namespace mesobridge::workflows
