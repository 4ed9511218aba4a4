#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/h5md.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {

namespace {

using tests::ScratchDirectory;

H5mdWriter::Frame frame_at(std::int64_t step, std::span<Vec3 const> q, std::span<Vec3 const> v) {
  return {.step = step,
          .time = 2e-12 * static_cast<double>(step),
          .box = {{1e-9, 2e-9, 3e-9}},
          .positions = q,
          .velocities = v};
}

TEST(H5md, FramesFollowTheFormat) {
  ScratchDirectory const scratch;
  std::vector<Vec3> const q{{1e-9, 0, 0}, {0, 2e-9, 0}, {0, 0, 0.5e-9}},
      v{{100, 0, 0}, {0, -50, 0}, {0, 0, 1000}};
  auto const file = scratch / "trajectory.h5md";
  {
    H5mdWriter writer(file, H5mdWriter::Units::si(),
                      {.command = "test", .seed = 1, .scene = "", .inputs = {}});
    writer.append(frame_at(0, q, v));
    writer.append_observable("P", 0, 0, 1e9, "Pa");
    writer.close();
  }
  {
    auto writer = H5mdWriter::continue_file(file, H5mdWriter::Units::si());
    EXPECT_EQ(writer.last_step(), 0);
    writer.append(frame_at(10, q, v));
    EXPECT_EQ(writer.last_step(), 10);
    writer.close();
  }
  Store const store(file, Store::Mode::read);
  EXPECT_TRUE(store.has_attribute("h5md", "version"));
  EXPECT_EQ(store.read_text_attribute("h5md/creator", "name"), "mesobridge");
  EXPECT_TRUE(store.has_attribute("h5md/author", "name"));
  EXPECT_EQ(store.read_integer_attribute("particles/trajectory/box", "dimension"), 3);
  EXPECT_EQ(store.shape("particles/trajectory/position/value"), (Store::Shape{2, 3, 3}));
  EXPECT_EQ(store.shape("particles/trajectory/box/edges/value"), (Store::Shape{2, 3, 3}));
  EXPECT_EQ(store.read_integers("particles/trajectory/position/step"), (std::vector<std::int64_t>{0, 10}));
  EXPECT_DOUBLE_EQ(store.read_doubles("particles/trajectory/position/time")[1], 20);   // ps
  EXPECT_DOUBLE_EQ(store.read_doubles("particles/trajectory/position/value")[4], 2);   // nm
  EXPECT_DOUBLE_EQ(store.read_doubles("particles/trajectory/velocity/value")[0], 0.1); // nm/ps
  EXPECT_DOUBLE_EQ(store.read_doubles("particles/trajectory/box/edges/value")[8], 3);
  EXPECT_EQ(store.read_text_attribute("particles/trajectory/position/value", "unit"), "nm");
  EXPECT_EQ(store.read_text_attribute("particles/trajectory/velocity/value", "unit"), "nm ps-1");
  EXPECT_EQ(store.read_text_attribute("particles/trajectory/position/time", "unit"), "ps");
  EXPECT_EQ(store.read_doubles("observables/P/value"), std::vector<double>{1e9});
  EXPECT_EQ(store.read_text_attribute("observables/P/value", "unit"), "Pa");
}

TEST(H5md, ANaNIsRefusedAndNothingOfItsFrameIsWritten) {
  ScratchDirectory const scratch;
  H5mdWriter writer(scratch / "t.h5md", H5mdWriter::Units::reduced(), {});
  EXPECT_EQ(writer.last_step(), -1);
  std::vector<Vec3> const good{{1, 2, 3}}, bad{{1, std::nan(""), 3}};
  writer.append(frame_at(0, good, {}));
  EXPECT_THROW(writer.append(frame_at(1, bad, {})), PhysicsError);
  EXPECT_THROW(writer.append_observable("P", 1, 0, std::nan("")), PhysicsError);
  writer.close();
  Store const store(scratch / "t.h5md", Store::Mode::read);
  EXPECT_EQ(store.shape("particles/trajectory/position/value"), (Store::Shape{1, 1, 3}));
  EXPECT_FALSE(store.contains("particles/trajectory/velocity"));
  EXPECT_FALSE(store.has_attribute("particles/trajectory/position/value", "unit"));
}

} // namespace

} // namespace mesobridge::workflows
