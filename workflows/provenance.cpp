#include "workflows/provenance.hpp"
#include "md/error.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <openssl/evp.h>

namespace mesobridge::workflows {

void write_provenance(Store& store, Provenance const& provenance) {
  constexpr char const* group = "provenance";
  store.set_attribute(group, "program", std::string("mesobridge"));
  store.set_attribute(group, "version", std::string(version()));
  store.set_attribute(group, "git_commit", std::string(git_commit()));
  store.set_attribute(group, "command", provenance.command);
  store.set_attribute(group, "seed", static_cast<std::int64_t>(provenance.seed));
  if (!provenance.scene.empty())
    store.write("provenance/scene", provenance.scene);
  for (auto const& input : provenance.inputs)
    store.set_attribute("provenance/inputs", "sha256 of " + input.filename().string(), sha256_of_file(input));
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
    json["inputs"][input.string()] = {{"sha256", sha256_of_file(input)}};
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
