#include "unit/workflows/scratch_directory.hpp"
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
