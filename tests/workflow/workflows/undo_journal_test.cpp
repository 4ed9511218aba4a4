#include "killed_writer.hpp"
#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/h5md.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/store/undo_journal.hpp"
#include "workflows/text_file.hpp"
#include "workflows/vtkhdf.hpp"
#include <fstream>
#include <gtest/gtest.h>

// What dies while it writes leaves files that go back to their last mark. The moments of death are not drawn
// at random: the writer is killed before each of its calls that change a file in turn.

namespace mesobridge::workflows {
namespace {

using tests::ends_before_change;
using tests::ScratchDirectory;

void overwrite(std::filesystem::path const& file, std::uint64_t offset, std::string const& text,
               UndoJournal& journal) {
  journal.protect(offset, text.size());
  std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
  out.seekp(static_cast<std::streamoff>(offset));
  out << text;
}

TEST(UndoJournal, LeadsBackToWhereItBegan) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f";
  std::string original;
  for (int i = 0; i < 3000; ++i)
    original += fmt::format("{:04}", i); // nearly three pages
  write_text_file(file, original);
  EXPECT_FALSE(UndoJournal::exists(file));
  UndoJournal::roll_back(file); // there is nothing to undo
  EXPECT_EQ(read_text_file(file), original);
  {
    UndoJournal journal(file);
    overwrite(file, 10, "first", journal);
    overwrite(file, 4000, std::string(200, 'x'), journal); // across a page's end
    overwrite(file, 4001, "again", journal);               // of what is overwritten already
    overwrite(file, original.size() - 2, "longer than it was", journal);
    overwrite(file, original.size() + 5000, "appended", journal);
    journal.protect_beyond(9000);
    std::filesystem::resize_file(file, 9000);
  }
  EXPECT_NE(read_text_file(file), original);
  // Each page once, and the header.
  EXPECT_EQ(std::filesystem::file_size(file.string() + ".undo"), 32u + 3u * (24u + 4096u));
  auto const journal = read_text_file(file.string() + ".undo");
  UndoJournal::roll_back(file);
  EXPECT_EQ(read_text_file(file), original);
  UndoJournal::roll_back(file); // as often as you like
  EXPECT_EQ(read_text_file(file), original);
  { // a part that is only cut off
    UndoJournal cut(file);
    cut.protect_beyond(5000);
    std::filesystem::resize_file(file, 5000);
  }
  UndoJournal::roll_back(file);
  EXPECT_EQ(read_text_file(file), original);
  // A record that is not complete is of a page that was not touched yet.
  write_text_file(file, original);
  overwrite(file, 10, "first", *std::make_unique<UndoJournal>(file));
  write_text_file(file.string() + ".undo", read_text_file(file.string() + ".undo") + journal.substr(32, 100));
  UndoJournal::roll_back(file);
  EXPECT_EQ(read_text_file(file), original);

  write_text_file(file.string() + ".undo", "something else of sixteen bytes or more");
  EXPECT_THROW(UndoJournal::roll_back(file), EnvironmentError);
  UndoJournal::discard(file);
  EXPECT_FALSE(UndoJournal::exists(file));
  EXPECT_THROW(UndoJournal(scratch / "missing"), EnvironmentError);
}

TEST(UndoJournal, LeavesAFileAloneThatItCannotLeadBack) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f", path = scratch / "f.undo";
  std::string const original(20000, 'o');
  write_text_file(file, original);
  {
    UndoJournal journal(file);
    overwrite(file, 10, "first", journal);
    overwrite(file, 9000, "second", journal);
  }
  auto const changed = read_text_file(file), journal = read_text_file(path);
  ASSERT_EQ(journal.size(), 32u + 2u * (24u + 4096u));
  int damaged = 0;
  for (std::size_t place = 0; place < journal.size(); place += place < 60 ? 1 : 97, ++damaged) {
    auto bytes = journal;
    bytes[place] = static_cast<char>(bytes[place] ^ 16);
    write_text_file(path, bytes);
    EXPECT_THROW(UndoJournal::roll_back(file), EnvironmentError) << place;
    ASSERT_EQ(read_text_file(file), changed) << place;
  }
  EXPECT_GT(damaged, 100);
  write_text_file(path, journal);
  for (std::size_t const place : {3000u, 15000u}) { // in a page that is restored, and in one that is not
    auto bytes = changed;
    bytes[place] = 'x';
    write_text_file(file, bytes);
    if (place == 3000)
      EXPECT_NO_THROW(UndoJournal::roll_back(file));
    else
      EXPECT_THROW(UndoJournal::roll_back(file), EnvironmentError);
    EXPECT_EQ(read_text_file(file), place == 3000 ? original : bytes);
  }
}

TEST(UndoJournal, BeginsAnewWithThePagesThatChanged) {
  ScratchDirectory const scratch;
  auto const file = scratch / "f";
  write_text_file(file, std::string(20480, 'o')); // five pages
  UndoJournal journal(file);
  overwrite(file, 10, "first", journal);
  overwrite(file, 20480, std::string(5000, 'a'), journal);
  overwrite(file, 20500, "twice", journal);
  journal.renew();
  auto const second = read_text_file(file);
  // What was there and changed, and what was added and changed since.
  EXPECT_EQ(std::filesystem::file_size(scratch / "f.undo"), 32u + 2u * (24u + 4096u));
  overwrite(file, 10, "again", journal);
  overwrite(file, 24600, "there", journal);
  UndoJournal::roll_back(file);
  EXPECT_EQ(read_text_file(file), second);
  UndoJournal(file).renew(); // no page changed under this one
  EXPECT_EQ(std::filesystem::file_size(scratch / "f.undo"), 32u);
}

constexpr std::size_t particles = 10;
constexpr std::int64_t frames = 5;

ParticleFrame frame(std::int64_t number) {
  ParticleFrame of{.step = number,
                   .time = 0.5 * static_cast<double>(number),
                   .box = {{4, 5, 6}},
                   .positions = {},
                   .velocities = {},
                   .scalars = {{"T", {}}}};
  for (std::size_t i = 0; i < particles; ++i) {
    double const label = 100.0 * static_cast<double>(number) + static_cast<double>(i);
    of.positions.push_back({label, label + 10, label + 20});
    of.velocities.push_back({-label, -label - 10, -label - 20});
    of.scalars[0].second.push_back(2 * label);
  }
  return of;
}

void append(H5mdWriter& writer, std::int64_t number) {
  auto const of = frame(number);
  writer.append({.step = of.step,
                 .time = of.time,
                 .box = of.box,
                 .positions = of.positions,
                 .velocities = of.velocities});
}
void append(VtkHdfWriter& writer, std::int64_t number) {
  writer.append(frame(number));
}

struct H5md {
  static H5mdWriter create(std::filesystem::path const& file) {
    return H5mdWriter(file, H5mdWriter::Units::reduced(), {});
  }
  static H5mdWriter resume(std::filesystem::path const& file) {
    return H5mdWriter::continue_file(file, H5mdWriter::Units::reduced());
  }
  static constexpr std::array datasets{
      "particles/trajectory/position/value",  "particles/trajectory/velocity/value",
      "particles/trajectory/position/time",   "particles/trajectory/velocity/time",
      "particles/trajectory/box/edges/value", "particles/trajectory/box/edges/time"};
  static constexpr std::array steps{"particles/trajectory/position/step",
                                    "particles/trajectory/velocity/step",
                                    "particles/trajectory/box/edges/step"};
};
struct VtkHdf {
  static VtkHdfWriter create(std::filesystem::path const& file) { return VtkHdfWriter(file, {}); }
  static VtkHdfWriter resume(std::filesystem::path const& file) { return VtkHdfWriter::continue_file(file); }
  static constexpr std::array datasets{"VTKHDF/Points", "VTKHDF/PointData/velocity", "VTKHDF/PointData/T",
                                       "VTKHDF/Steps/Values"};
  static constexpr std::array steps{"mesobridge/step",
                                    "VTKHDF/NumberOfPoints",
                                    "VTKHDF/NumberOfCells",
                                    "VTKHDF/NumberOfConnectivityIds",
                                    "VTKHDF/Offsets",
                                    "VTKHDF/Connectivity",
                                    "VTKHDF/PointData/id",
                                    "VTKHDF/Steps/PartOffsets",
                                    "VTKHDF/Steps/NumberOfParts",
                                    "VTKHDF/Steps/PointOffsets",
                                    "VTKHDF/Steps/CellOffsets",
                                    "VTKHDF/Steps/ConnectivityIdOffsets",
                                    "VTKHDF/Steps/PointDataOffsets/velocity",
                                    "VTKHDF/Steps/PointDataOffsets/id",
                                    "VTKHDF/Steps/PointDataOffsets/T"};
};

/// Blobs are handed over in stretches, and each stretch is marked.
class BlobWriter {
 public:
  explicit BlobWriter(BlobFile file) : file_(std::move(file)) {}
  static std::int64_t last_step() { return -1; } // the file itself knows what it has
  void hold(cg::BlobFrame frame) { held_.push_back(std::move(frame)); }
  void mark() {
    file_.append(held_);
    held_.clear();
  }
  void close() {
    mark();
    file_.close();
  }

 private:
  BlobFile file_;
  std::vector<cg::BlobFrame> held_;
};
void append(BlobWriter& writer, std::int64_t number) {
  auto const of = frame(number);
  cg::BlobFrame blobs{.step = of.step, .time = of.time, .box = of.box, .blobs = {}};
  for (std::size_t i = 0; i < particles; ++i)
    blobs.blobs.push_back({.R = of.positions[i], .P = of.velocities[i], .U_kin = of.velocities[i].x});
  writer.hold(std::move(blobs));
}
struct Blobs {
  static BlobWriter create(std::filesystem::path const& file) {
    return BlobWriter(BlobFile(file, {.kind = "melt", .fingerprint = "f", .molecules = particles}, {}));
  }
  static BlobWriter resume(std::filesystem::path const& file) {
    return BlobWriter(BlobFile::continue_file(file, "f"));
  }
  static constexpr std::array datasets{"blobs/R",       "blobs/P",        "blobs/F",     "blobs/U_kin",
                                       "blobs/U_pot",   "blobs/Phi",      "frames/time", "frames/box",
                                       "frames/energy", "frames/pressure"};
  static constexpr std::array steps{"frames/step"};
};

template <class Format>
std::pair<std::vector<std::vector<double>>, std::vector<std::vector<std::int64_t>>>
content(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  std::pair<std::vector<std::vector<double>>, std::vector<std::vector<std::int64_t>>> all;
  for (auto const* name : Format::datasets)
    all.first.push_back(store.read_doubles(name));
  for (auto const* name : Format::steps)
    all.second.push_back(store.read_integers(name));
  if (store.has_attribute("VTKHDF/Steps", "NSteps"))
    all.second.push_back({store.read_integer_attribute("VTKHDF/Steps", "NSteps")});
  return all;
}

/// Writes all frames with a mark after every second, and beside the file, as a run does in its checkpoint,
/// how many are marked; goes on from there if there is such a number.
template <class Format>
void write_frames(std::filesystem::path const& file) {
  auto const note = file.string() + ".marked";
  bool const begun = std::filesystem::exists(note);
  auto writer = begun ? Format::resume(file) : Format::create(file);
  for (auto next = begun ? std::stoll(read_text_file(note)) : 0; next < frames; ++next) {
    if (next > writer.last_step())
      append(writer, next);
    if (next % 2 == 1) {
      writer.mark();
      write_text_file(note, std::to_string(next + 1));
    }
  }
  writer.close();
}

template <class Format>
class MarkedFile : public ::testing::Test {};
using Formats = ::testing::Types<H5md, VtkHdf, Blobs>;
TYPED_TEST_SUITE(MarkedFile, Formats);

TYPED_TEST(MarkedFile, IsWholeAfterADeathBeforeAnyOfItsWrites) {
  if (!tests::may_trace())
    GTEST_SKIP() << "this machine does not let a process follow the calls of its child";
  ScratchDirectory const scratch;
  auto const whole = scratch / "whole.h5", broken = scratch / "broken.h5";
  write_frames<TypeParam>(whole);
  auto const expected = content<TypeParam>(whole);
  ASSERT_EQ(expected.first[0].size(), frames * particles * 3);
  std::size_t deaths = 0;
  for (std::size_t last = 1; !ends_before_change(last, [&] { write_frames<TypeParam>(broken); }); ++last) {
    ++deaths;
    if (deaths % 8 == 0) // now and then one that goes on dies as well
      ends_before_change(last / 2 + 1, [&] { write_frames<TypeParam>(broken); });
    write_frames<TypeParam>(broken);
    ASSERT_TRUE(content<TypeParam>(broken) == expected) << last;
    EXPECT_FALSE(UndoJournal::exists(broken));
    std::filesystem::remove(broken.string() + ".marked");
  }
  this->RecordProperty("deaths", std::to_string(deaths));
  EXPECT_GT(deaths, 50u);
}

// The same deaths without marks leave damaged files: the test above would see it.
TEST(PlainFile, MayBeDamagedByADeath) {
  if (!tests::may_trace())
    GTEST_SKIP() << "this machine does not let a process follow the calls of its child";
  ScratchDirectory const scratch;
  auto const file = scratch / "f.h5";
  auto write = [&] {
    Store store(file, Store::Mode::create);
    for (std::int64_t k = 0; k < 40; ++k) {
      std::vector<double> const row(3000, static_cast<double>(k));
      store.append("a", row, {row.size()});
      store.append("b", row, {row.size()});
      store.flush();
    }
  };
  std::size_t damaged = 0, deaths = 0;
  for (std::size_t last = 40; !ends_before_change(last, write); last += 7, ++deaths) {
    try {
      Store const store(file, Store::Mode::read);
      auto const a = store.read_doubles("a"), b = store.read_doubles("b");
      damaged += a.size() != b.size();
    } catch (std::exception const&) {
      ++damaged;
    }
  }
  EXPECT_GT(deaths, 5u);
  EXPECT_GT(damaged, 0u);
}

} // namespace
} // namespace mesobridge::workflows
