#include "error_text.hpp"
#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/store/store.hpp"
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <hdf5.h>

namespace mesobridge::workflows {

namespace {

using tests::ScratchDirectory, tests::error_text;
using Doubles = std::vector<double>;
using Integers = std::vector<std::int64_t>;

void expect_words(std::string const& message, std::vector<std::string> const& words) {
  for (auto const& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' not in: " << message;
}

/// Writes what no Store writes, by HDF5's own calls.
class RawFile {
 public:
  explicit RawFile(std::filesystem::path const& file)
      : file_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~RawFile() { H5Fclose(file_); }

  void dataset(char const* name, hid_t type, hid_t space, void const* data, hid_t layout = H5P_DEFAULT) {
    hid_t const set = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, layout, H5P_DEFAULT);
    if (data)
      H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
    H5Dclose(set), H5Sclose(space);
  }
  void attribute(char const* name, hid_t type, hid_t space, void const* data) {
    hid_t const made = H5Acreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(made, type, data);
    H5Aclose(made), H5Sclose(space);
  }

 private:
  hid_t file_;
};

hid_t space_of(std::vector<hsize_t> const& extents) {
  return H5Screate_simple(int(extents.size()), extents.data(), nullptr);
}

TEST(StoreReading, AColumnIsWhatItsReaderWantsOrRefused) {
  ScratchDirectory const scratch;
  Store store(scratch / "a.h5", Store::Mode::create);
  store.write("R", Doubles{1, 2, 3, 4, 5, 6}, {2, 3});
  store.write("step", Integers{3, 5});
  store.write("U", Doubles{1.5, std::nan("")});
  store.write("none", Doubles{}, {0, 3});
  store.write("text", std::string("x"));

  EXPECT_EQ(store.read_doubles("R", {.rows = 2, .row_shape = Store::Shape{3}}).size(), 6u);
  EXPECT_EQ(store.read_integers("step", {.least_rows = 1, .row_shape = Store::Shape{}}), (Integers{3, 5}));
  EXPECT_EQ(store.read_row("R", 1), (Doubles{4, 5, 6}));
  EXPECT_EQ(store.read_integer_row("step", 1), Integers{5});
  EXPECT_EQ(store.read_doubles("U", {.bounds = {.finite = false}}).size(), 2u);
  EXPECT_EQ(store.rows("none"), 0u);
  EXPECT_EQ(store.read_doubles("none").size(), 0u);

  struct Refused {
    std::function<void()> act;
    std::vector<std::string> words;
  };
  std::vector<Refused> const all{
      {[&] { store.read_doubles("R", {.rows = 3}); }, {"a.h5", "'R'", "2 x 3", "3 x anything"}},
      {[&] { store.read_doubles("R", {.row_shape = Store::Shape{}}); }, {"'R'", "2 x 3", "in one row"}},
      {[&] {
         store.read_doubles("R", {.row_shape = Store::Shape{3, 1}});
       },
       {"'R'", "x 3 x 1"}},
      {[&] { store.read_doubles("none", {.least_rows = 1}); }, {"'none'", "0 x 3", "at least 1"}},
      {[&] { store.read_doubles("R", {.bounds = {.most = 4.5}}); }, {"[1][1] = 5", "<= 4.5"}},
      {[&] { store.read_row("R", 1, {.bounds = {.above = 4}}); }, {"[1][0] = 4", "> 4"}},
      {[&] { store.read_row("R", 2); }, {"2 x 3", "no row 2"}},
      {[&] { store.read_doubles("U"); }, {"'U'[1] = nan", "finite"}},
      {[&] { store.read_integers("step", {.bounds = {.least = 4}}); }, {"'step'[0] = 3", ">= 4"}},
      {[&] { store.read_integers("R"); }, {"'R'", "floating-point", "integers"}},
      {[&] { store.read_doubles("text"); }, {"'text'", "texts", "numbers"}},
      {[&] { store.read_doubles("missing"); }, {"a.h5", "no dataset 'missing'"}},
      {[&] { store.read_text("R"); }, {"'R'", "no text"}},
      {[&] { store.list("R"); }, {"no group 'R'"}},
  };
  std::size_t tried = 0;
  for (auto const& one : all) {
    auto const message = error_text(one.act);
    EXPECT_FALSE(message.empty()) << tried;
    expect_words(message, one.words);
    ++tried;
  }
  EXPECT_EQ(tried, 14u);
}

TEST(StoreReading, AttributesAreOneNumberOrOneText) {
  ScratchDirectory const scratch;
  std::vector<double> const many{1, 2, 3};
  double const one = 7, inf = INFINITY;
  {
    RawFile raw(scratch / "a.h5");
    raw.attribute("array", H5T_NATIVE_DOUBLE, space_of({3}), many.data());
    raw.attribute("one of one", H5T_NATIVE_DOUBLE, space_of({1}), &one);
    raw.attribute("infinite", H5T_NATIVE_DOUBLE, H5Screate(H5S_SCALAR), &inf);
    raw.attribute("nothing", H5T_NATIVE_DOUBLE, H5Screate(H5S_NULL), &one);
    hid_t const text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, 4);
    raw.attribute("fixed", text, H5Screate(H5S_SCALAR), "abcd");
    raw.attribute("two", text, space_of({2}), "ab\0\0cdef");
    raw.attribute("latin", text, H5Screate(H5S_SCALAR), "\xfc\0\0");
    H5Tclose(text);
  }
  Store const store(scratch / "a.h5", Store::Mode::read);
  EXPECT_EQ(store.read_double_attribute("/", "one of one"), 7);
  EXPECT_EQ(store.read_text_attribute("/", "fixed"), "abcd");
  EXPECT_EQ(store.read_text_attributes("/", "two"), (std::vector<std::string>{"ab", "cdef"}));
  expect_words(error_text([&] { store.read_double_attribute("/", "array"); }), {"array", "3", "one number"});
  expect_words(error_text([&] { store.read_integer_attribute("/", "array"); }), {"array", "one integer"});
  expect_words(error_text([&] { store.read_integer_attribute("/", "one of one"); }),
               {"floating", "one integer"});
  expect_words(error_text([&] { store.read_double_attribute("/", "fixed"); }),
               {"fixed", "texts", "one number"});
  expect_words(error_text([&] { store.read_double_attribute("/", "infinite"); }), {"inf", "finite"});
  expect_words(error_text([&] { store.read_double_attribute("/", "nothing"); }), {"nothing", "one number"});
  expect_words(error_text([&] { store.read_double_attribute("/", "one of one", {.most = 6}); }),
               {"7", "<= 6"});
  expect_words(error_text([&] { store.read_text_attribute("/", "two"); }), {"array of 2", "one text"});
  expect_words(error_text([&] { store.read_text_attribute("/", "latin"); }), {"UTF-8"});
  expect_words(error_text([&] { store.read_text_attribute("/", "array"); }), {"array", "must be a text"});
  expect_words(error_text([&] { store.read_text_attribute("/", "missing"); }), {"no attribute 'missing'"});
}

TEST(StoreReading, SizesThatTheFileCannotHoldAreNotAllocated) {
  ScratchDirectory const scratch;
  {
    RawFile raw(scratch / "a.h5");
    hid_t const late = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(late, 1, std::vector<hsize_t>{1024}.data());
    raw.dataset("huge", H5T_NATIVE_DOUBLE, space_of({hsize_t{1} << 40}), nullptr, late);
    raw.dataset("small", H5T_NATIVE_DOUBLE, space_of({2000}), nullptr, late);
    H5Pset_deflate(late, 9);
    raw.dataset("packed and huge", H5T_NATIVE_DOUBLE, space_of({hsize_t{1} << 40}), nullptr, late);
    std::vector<double> const zeros(1 << 20, 0.0);
    raw.dataset("packed", H5T_NATIVE_DOUBLE, space_of({zeros.size()}), zeros.data(), late);
    std::uint64_t const large = ~std::uint64_t{0};
    raw.dataset("unsigned", H5T_NATIVE_UINT64, H5Screate(H5S_SCALAR), &large);
    raw.dataset("null", H5T_NATIVE_DOUBLE, H5Screate(H5S_NULL), nullptr);
    H5Pclose(late);
  }
  Store const store(scratch / "a.h5", Store::Mode::read);
  for (char const* name : {"huge", "packed and huge"}) {
    expect_words(error_text([&] { store.read_doubles(name); }), {name, "1099511627776", "damaged"});
    expect_words(error_text([&] { store.read_row(name, 1); }), {name, "damaged"});
  }
  EXPECT_EQ(store.read_doubles("small"), Doubles(2000, 0.0)); // HDF5's value of what was never written
  EXPECT_EQ(store.read_doubles("packed").size(), std::size_t{1} << 20);
  EXPECT_TRUE(store.read_doubles("null").empty());
  expect_words(error_text([&] { store.read_integers("unsigned"); }), {"unsigned", "must be"});
}

TEST(StoreReading, ABrokenFileIsTheInputsFault) {
  ScratchDirectory const scratch;
  {
    Store store(scratch / "a.h5", Store::Mode::create);
    store.write("R", Doubles(10000, 1.0));
    store.close();
  }
  auto const whole = std::filesystem::file_size(scratch / "a.h5");
  std::size_t tried = 0;
  for (auto const size : {whole - 1, whole / 2, std::uintmax_t{100}, std::uintmax_t{8}, std::uintmax_t{0}}) {
    std::filesystem::copy_file(scratch / "a.h5", scratch / "b.h5",
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(scratch / "b.h5", size);
    expect_words(error_text([&] { Store(scratch / "b.h5", Store::Mode::read).read_doubles("R"); }), {"b.h5"});
    ++tried;
  }
  EXPECT_EQ(tried, 5u);
}

} // namespace

} // namespace mesobridge::workflows
