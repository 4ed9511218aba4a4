#include "scratch_directory.hpp"
#include "workflows/size_study/parts.hpp"
#include "workflows/study/stored_part.hpp"
#include <cstring>
#include <gtest/gtest.h>

namespace mesobridge::workflows {

struct SomePart {
  std::string name;
  double value = 0;
  std::size_t count = 0;
  cg::Estimate estimate;
  sdpd::Drift drift;
  std::vector<double> numbers;
};

template <class Result, class F>
requires std::is_same_v<std::remove_const_t<Result>, SomePart>
void for_each_member(Result& part, F const& f) {
  f("name", part.name), f("value", part.value), f("count", part.count);
  f("estimate", part.estimate), f("drift", part.drift), f("numbers", part.numbers);
}

namespace {

bool same_bits(std::vector<double> const& a, std::vector<double> const& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

SomePart some_part() {
  return {"a \"quoted\" name",
          1.0 / 3,
          7,
          {std::sqrt(2.0), 1e-300, 12.5},
          {-1e-17, 5e-324},
          {-0.0, 0.1, 1e308, std::nextafter(1.0, 2.0)}};
}

TEST(StoredPart, ReadsBackToTheSameBits) {
  tests::ScratchDirectory const scratch;
  auto const part = some_part();
  write_part(scratch / "part.json", "made of this", part);
  auto const back = read_part<SomePart>(scratch / "part.json", "made of this");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->name, part.name);
  EXPECT_EQ(back->count, part.count);
  EXPECT_TRUE(same_bits(back->numbers, part.numbers));
  EXPECT_TRUE(same_bits({back->value, back->estimate.mean, back->estimate.se, back->estimate.n_eff,
                         back->drift.rate, back->drift.se},
                        {part.value, part.estimate.mean, part.estimate.se, part.estimate.n_eff,
                         part.drift.rate, part.drift.se}));
}

/// Writes, reads and writes a part again: the two files must be the same.
template <class Part>
void expect_same_again(Part const& part) {
  tests::ScratchDirectory const scratch;
  write_part(scratch / "a.json", "this", part);
  auto const back = read_part<Part>(scratch / "a.json", "this");
  ASSERT_TRUE(back);
  write_part(scratch / "b.json", "this", *back);
  EXPECT_EQ(read_text_file(scratch / "a.json"), read_text_file(scratch / "b.json"));
}

// Structures without names for what they have: a member more, and this does not compile.
TEST(StoredPart, OfTheSizeStudyHasAllMembers) {
  FluidRun const run{"cubic", 5,  Treatment::free, {1.1, 0.2}, {1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12},
                     13,      14, {15, 16},        {17, 18}};
  expect_same_again(run);
  tests::ScratchDirectory const scratch;
  write_part(scratch / "run.json", "this", run);
  auto const [kernel, K, treatment, constants, P, rho, T_kin, T_int, energy, expected, rho_i, P_i] =
      *read_part<FluidRun>(scratch / "run.json", "this");
  EXPECT_EQ(kernel, "cubic");
  EXPECT_EQ(treatment, Treatment::free);
  EXPECT_EQ((std::vector{K, constants.scale, constants.self, P.mean, rho.se, T_kin.n_eff, T_int.mean, energy,
                         expected, rho_i[1], P_i[1]}),
            (std::vector<double>{5, 1.1, 0.2, 1, 5, 9, 10, 13, 14, 16, 18}));
  SizeCalibration const calibration{"lucy", 10, {{1.1, 0.2}, 1, 2, {3, 4, 5}, {6, 7, 8}, 9, 10, 11}};
  expect_same_again(calibration);
  write_part(scratch / "calibration.json", "this", calibration);
  auto const [name, size, found] = *read_part<SizeCalibration>(scratch / "calibration.json", "this");
  auto const [c, scale_se, self_se, density, pressure, P_eos, particles, steps] = found;
  EXPECT_EQ((std::vector{size, c.scale, c.self, scale_se, self_se, density.mean, pressure.se, P_eos}),
            (std::vector<double>{10, 1.1, 0.2, 1, 2, 3, 7, 9}));
  EXPECT_EQ(particles, 10u);
  EXPECT_EQ(steps, 11u);
  expect_same_again(Structure{"cubic", {1, 2}, {3, 4}, 0.5});
}

TEST(StoredPart, IsMadeOnceAndAgainWhenItIsOfSomethingElseOrDamaged) {
  tests::ScratchDirectory const scratch;
  auto const file = scratch / "part.json";
  int made = 0;
  auto const make = [&] {
    ++made;
    return some_part();
  };
  stored_or_made(file, "this", make);
  EXPECT_EQ(stored_or_made(file, "this", make).count, 7u);
  EXPECT_EQ(made, 1);
  stored_or_made(file, "that", make);
  EXPECT_EQ(made, 2);
  auto text = read_text_file(file);
  write_text_file(file, text.substr(0, text.size() / 2));
  stored_or_made(file, "that", make);
  EXPECT_EQ(made, 3);
  stored_or_made(file, "that", make);
  EXPECT_EQ(made, 3);
  EXPECT_FALSE(read_part<SomePart>(scratch / "none.json", "that"));
}

} // namespace
} // namespace mesobridge::workflows
