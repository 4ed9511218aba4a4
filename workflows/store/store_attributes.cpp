#include "workflows/store/damage_guard.hpp"
#include "workflows/store/reading.hpp"

namespace mesobridge::workflows {

Hdf5Handle Store::Implementation::open_attribute(std::string const& path, std::string const& name) const {
  if (!contains(path) || H5Aexists_by_name(handle.get(), path.c_str(), name.c_str(), H5P_DEFAULT) <= 0)
    throw InputError(fmt::format("'{}' has no attribute '{}' at '{}'", file.string(), name, path));
  return opened(
      {H5Aopen_by_name(handle.get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose},
      "cannot open attribute '" + name + "' of");
}

template <class T>
T Store::Implementation::read_number_attribute(std::string const& path, std::string const& name,
                                               Bounds const& bounds) const {
  auto const attribute = open_attribute(path, name);
  Hdf5Handle const type(H5Aget_type(attribute.get()), H5Tclose);
  Reading const reading(file, fmt::format("attribute '{}' of '{}'", name, path));
  auto const shape = shape_of_space({H5Aget_space(attribute.get()), H5Sclose});
  if (!holds<T>(H5Tget_class(type.get())))
    reading.refuse(fmt::format("holds {}: must be {}", class_text(H5Tget_class(type.get())),
                               std::is_same_v<T, double> ? "one number" : "one integer"));
  if (bytes_of(shape, 1) != 1)
    reading.refuse(fmt::format("is an array of {}: must be one number", shape_text(shape)));
  std::vector<T> value(1);
  if (H5Aread(attribute.get(), memory_type<T>(), value.data()) < 0)
    refuse("cannot read attribute '" + name + "' of");
  reading.check_values(value, type.get(), {}, bounds);
  return value[0];
}

double Store::read_double_attribute(std::string const& object, std::string const& name,
                                    Bounds const& bounds) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->read_number_attribute<double>(object, name, bounds);
}
std::int64_t Store::read_integer_attribute(std::string const& object, std::string const& name,
                                           Bounds const& bounds) const {
  DamageGuard const guard(implementation_->file);
  return implementation_->read_number_attribute<std::int64_t>(object, name, bounds);
}

/// Of variable or of fixed length: both are in use.
std::vector<std::string> Store::read_text_attributes(std::string const& object,
                                                     std::string const& name) const {
  DamageGuard const guard(implementation_->file);
  auto const& self = *implementation_;
  auto const attribute = self.open_attribute(object, name);
  Hdf5Handle const type(H5Aget_type(attribute.get()), H5Tclose),
      space(H5Aget_space(attribute.get()), H5Sclose);
  Reading const reading(self.file, fmt::format("attribute '{}' of '{}'", name, object));
  if (H5Tget_class(type.get()) != H5T_STRING)
    reading.refuse(fmt::format("holds {}: must be a text", class_text(H5Tget_class(type.get()))));
  auto const what = "cannot read attribute '" + name + "' of";
  auto const count = bytes_of(shape_of_space(space), 1);
  auto const size = H5Tget_size(type.get());
  if (count == 0 || bytes_of({count}, size) > std::filesystem::file_size(file()))
    reading.refuse(count == 0 ? "holds nothing: must be a text" : "is larger than the file: it is damaged");
  std::vector<std::string> texts;
  if (H5Tis_variable_str(type.get()) > 0) {
    std::vector<char*> data(count, nullptr);
    auto memory = attribute_text_type();
    H5Tset_cset(memory.get(), H5Tget_cset(type.get()));
    if (H5Aread(attribute.get(), memory.get(), static_cast<void*>(data.data())) < 0)
      self.refuse(what);
    for (char* const text : data)
      texts.emplace_back(text ? text : "");
    H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, static_cast<void*>(data.data()));
  } else {
    std::string all(count * size, '\0');
    if (H5Aread(attribute.get(), type.get(), all.data()) < 0)
      self.refuse(what);
    for (std::size_t k = 0; k < count; ++k) {
      auto const text = all.substr(k * size, size);
      texts.push_back(text.substr(0, text.find('\0')));
    }
  }
  for (auto const& text : texts)
    if (!is_utf8(text))
      reading.refuse("is no text in UTF-8");
  return texts;
}

std::string Store::read_text_attribute(std::string const& object, std::string const& name) const {
  DamageGuard const guard(implementation_->file);
  auto const texts = read_text_attributes(object, name);
  if (texts.size() != 1)
    throw InputError(fmt::format("'{}': attribute '{}' of '{}' is an array of {}: must be one text",
                                 file().string(), name, object, texts.size()));
  return texts[0];
}

bool Store::has_attribute(std::string const& object, std::string const& name) const {
  DamageGuard const guard(implementation_->file);
  auto const& self = *implementation_;
  return self.contains(object) &&
         H5Aexists_by_name(self.handle.get(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

} // namespace mesobridge::workflows
