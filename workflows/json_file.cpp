#include "workflows/json_file.hpp"
#include "md/error.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {

Json read_json(std::filesystem::path const& file) {
  try {
    return Json::parse(read_text_file(file));
  } catch (Json::exception const& error) {
    throw InputError(fmt::format("'{}' is damaged: {}", file.string(), error.what()));
  }
}

} // namespace mesobridge::workflows
