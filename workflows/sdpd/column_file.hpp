#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// Reads a table of numbers from a CSV file as parse_csv understands it. Every required column must be there,
/// optional ones may, others may not. Throws InputError with file and line.
std::map<std::string, std::vector<double>> read_columns(std::filesystem::path const& file,
                                                        std::vector<std::string> const& required,
                                                        std::vector<std::string> const& optional);

} // namespace mesobridge::workflows
