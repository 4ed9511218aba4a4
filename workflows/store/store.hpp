#pragma once
#include "workflows/store/expected.hpp"
#include <filesystem>
#include <memory>
#include <span>

namespace mesobridge::workflows {

/// One HDF5 file. Objects are named by paths ("states/0/U"); groups on the way are created as needed.
///
/// Every failure is an EnvironmentError that names the file, what was tried and HDF5's own cause (a full
/// disk, say). Whatever is read is checked before it is taken: its kind, its shape, that the file is large
/// enough to hold it, the values. A file that cannot be read, lacks what was asked for, or holds something
/// else there, is an InputError that names the file, the place, what it holds and what is allowed.
class Store {
 public:
  enum class Mode {
    create, ///< a new file; one of the same name is replaced
    read,
    append ///< an existing file, to be written on
  };
  /// What a process that dies while it writes leaves behind.
  enum class Safety {
    plain, ///< perhaps a damaged file
    marked ///< a file that returns to its last mark() when it is opened to append (see UndoJournal)
  };
  using Shape = Expected::Shape;

  /// Waits some seconds for another process that has the file open (see FileLock).
  Store(std::filesystem::path file, Mode mode, Safety safety = Safety::plain);
  Store(Store&&) noexcept;
  ~Store(); ///< closes silently; call close() to learn whether all is on the disk

  /// Writes a dataset whole; an empty shape stands for one dimension.
  void write(std::string const& path, std::span<double const> values, Shape const& shape = {});
  void write(std::string const& path, std::span<std::int64_t const> values, Shape const& shape = {});
  void write(std::string const& path, std::span<std::uint8_t const> values);
  void write(std::string const& path, std::string const& text);

  /// Appends one row (or several, when there are more values than one row holds) to a dataset which grows
  /// along its first dimension; the first call creates it. An empty row shape stands for rows of one number.
  void append(std::string const& path, std::span<double const> values, Shape const& row_shape = {});
  void append(std::string const& path, std::span<std::int64_t const> values, Shape const& row_shape = {});

  /// A dataset that shows `rows` rows of one of another file from the `first` on (a virtual dataset of HDF5
  /// 1.10): it holds no numbers of its own, and follows the other file while both keep their places to each
  /// other.
  void write_view(std::string const& path, Store const& source, std::string const& source_path,
                  std::size_t first, std::size_t rows);

  /// A dataset whole, row after row. Integers are numbers, too, but no number with a point is an integer.
  std::vector<double> read_doubles(std::string const& path, Expected const& expected = {}) const;
  std::vector<std::int64_t> read_integers(std::string const& path, Expected const& expected = {}) const;
  /// One row of a dataset with rows; `expected` describes all of it, its bounds are those of the row.
  std::vector<double> read_row(std::string const& path, std::size_t row, Expected const& expected = {}) const;
  std::vector<std::int64_t> read_integer_row(std::string const& path, std::size_t row,
                                             Expected const& expected = {}) const;
  std::string read_text(std::string const& path) const;
  Shape shape(std::string const& path) const;      ///< empty for a single number
  std::size_t rows(std::string const& path) const; ///< the first extent; a single number is refused
  bool contains(std::string const& path) const;
  bool is_group(std::string const& path) const;
  std::vector<std::string> list(std::string const& group) const; ///< names in a group, sorted

  /// Attributes of a group or dataset (created as a group if it is not there). An old value is replaced.
  void set_attribute(std::string const& object, std::string const& name, double value);
  void set_attribute(std::string const& object, std::string const& name, std::int64_t value);
  void set_attribute(std::string const& object, std::string const& name,
                     std::span<std::int64_t const> values);
  void set_attribute(std::string const& object, std::string const& name, std::string const& text);
  void set_attribute(std::string const& object, std::string const& name, std::span<std::string const> texts);
  /// As ASCII characters of fixed length, which VTK wants.
  void set_ascii_attribute(std::string const& object, std::string const& name, std::string const& text);
  /// One number or one text: an array of several is refused.
  double read_double_attribute(std::string const& object, std::string const& name,
                               Bounds const& bounds = {}) const;
  std::int64_t read_integer_attribute(std::string const& object, std::string const& name,
                                      Bounds const& bounds = {}) const;
  std::string read_text_attribute(std::string const& object, std::string const& name) const;
  /// One text or several.
  std::vector<std::string> read_text_attributes(std::string const& object, std::string const& name) const;
  bool has_attribute(std::string const& object, std::string const& name) const;

  /// Makes the second path another name of the first object (a hard link).
  void link(std::string const& existing, std::string const& path);

  void flush(); ///< hands all data to the operating system: what was flushed survives the program's death
  void mark();  ///< flushes; whatever happens to the program later, all that is in the file now is safe
  void close(); ///< flushes and closes; the store is unusable afterwards

  std::filesystem::path const& file() const;

  /// Leads a marked file whose writer died back to its last mark; nothing happens to others. Throws
  /// EnvironmentError when somebody still has it open after `patience` seconds, or those that writers wait.
  static void mend(std::filesystem::path const& file, double patience);
  static void mend(std::filesystem::path const& file);

  /// Rows that a growing dataset takes room for at a time, by the bytes of a row: chunks of about 64 kB,
  /// large enough for the disk, small enough that a short series wastes little.
  static std::size_t chunk_rows(std::size_t row_bytes);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// "1.10.8"
std::string store_library_version();

} // namespace mesobridge::workflows
