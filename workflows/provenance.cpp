#include "workflows/provenance.hpp"
#include "md/error.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <openssl/evp.h>
#include <sstream>

namespace mesobridge::workflows {

InputFile::InputFile(std::filesystem::path file) : path(std::move(file)), sha256(sha256_of_file(path)) {}

void write_provenance(Store& store, Provenance const& provenance) {
  constexpr char const* group = "provenance";
  store.set_attribute(group, "program", std::string("mesobridge"));
  store.set_attribute(group, "version", std::string(version()));
  store.set_attribute(group, "git_commit", std::string(git_commit()));
  store.set_attribute(group, "command", provenance.command);
  store.set_attribute(group, "seed", static_cast<std::int64_t>(provenance.seed));
  if (!provenance.scene.empty())
    store.write("provenance/scene", provenance.scene);
  std::string sums; // as sha256sum writes and checks them
  for (auto const& input : provenance.inputs) {
    store.set_attribute("provenance/inputs", "sha256 of " + input.path.filename().string(), input.sha256);
    sums += input.sha256 + "  " + input.path.string() + "\n";
  }
  if (!sums.empty())
    store.write("provenance/sha256sums", sums);
}

std::vector<InputFile> read_inputs(Store const& store) {
  std::vector<InputFile> inputs;
  if (!store.contains("provenance/sha256sums"))
    return inputs;
  constexpr std::size_t digits = 64;
  std::istringstream lines(store.read_text("provenance/sha256sums"));
  for (std::string line; std::getline(lines, line);)
    if (line.size() > digits + 2)
      inputs.emplace_back(line.substr(digits + 2), line.substr(0, digits));
  return inputs;
}

Json provenance_json(Provenance const& provenance) {
  Json json{{"program", "mesobridge"},
            {"version", version()},
            {"git_commit", git_commit()},
            {"command", provenance.command},
            {"seed", provenance.seed}};
  if (!provenance.scene.empty())
    json["scene"] = provenance.scene;
  for (auto const& input : provenance.inputs)
    json["inputs"][input.path.string()] = {{"sha256", input.sha256}};
  return json;
}

std::string sha256_of_file(std::filesystem::path const& file) {
  return sha256(read_text_file(file));
}

std::string sha256(std::string_view text) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(text.data(), text.size(), digest, &size, EVP_sha256(), nullptr) != 1)
    throw EnvironmentError("the SHA-256 of OpenSSL does not work");
  return fmt::format("{:02x}", fmt::join(digest, digest + size, ""));
}

} // namespace mesobridge::workflows
