#include "hdf5_numbers.hpp"
#include <cstring>
#include <iostream>

// same_numbers A.h5 B.h5: succeeds when both hold the same numbers under the same names, bit for bit. What
// was written of the program and the time (attributes, texts) is left aside.

using mesobridge::tests::numbers_of;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: same_numbers A.h5 B.h5\n";
    return 2;
  }
  auto const a = numbers_of(argv[1]), b = numbers_of(argv[2]);
  if (a.empty() || a.size() != b.size()) {
    std::cerr << argv[1] << " holds " << a.size() << " datasets, " << argv[2] << " " << b.size() << "\n";
    return 1;
  }
  for (std::size_t k = 0; k < a.size(); ++k) {
    auto const& [name, x] = a[k];
    auto const& y = b[k].second;
    if (name != b[k].first || x.size() != y.size() || std::memcmp(x.data(), y.data(), 8 * x.size()) != 0) {
      std::cerr << argv[1] << " and " << argv[2] << " differ in " << name << "\n";
      return 1;
    }
  }
  return 0;
}
