#include "workflows/store/undo_journal.hpp"
#include "md/error.hpp"
#include "workflows/store/file_lock.hpp"
#include <algorithm>
#include <array>
#include <cstddef>
#include <fcntl.h>
#include <map>
#include <sys/file.h>
#include <utility>

namespace mesobridge::workflows {
namespace {

constexpr std::uint64_t page_size = PageDigest::page_size;

/// What a journal begins with.
struct Header {
  std::array<char, 8> name{'u', 'n', 'd', 'o', ' ', 'v', '2', '\n'};
  std::uint64_t length = 0, digest = 0; ///< of the file
  std::uint64_t crc = 0;                ///< of what stands above
  std::uint64_t own_crc() const { return PageDigest::crc(bytes_of(*this).first(offsetof(Header, crc))); }
};

/// A page as it was. A record that is not complete belongs to a page that was not touched yet.
struct Record {
  std::uint64_t number = 0, page = 0; ///< the number counts the journal's records
  std::array<char, page_size> bytes{};
  std::uint64_t crc = 0; ///< of what stands above
  std::uint64_t own_crc() const { return PageDigest::crc(bytes_of(*this).first(offsetof(Record, crc))); }
};

std::filesystem::path journal_of(std::filesystem::path const& file) {
  return std::filesystem::path(file).concat(".undo");
}

std::uint64_t offset_of_record(std::uint64_t number) {
  return sizeof(Header) + number * sizeof(Record);
}

std::uint64_t length_of(std::filesystem::path const& file) {
  return length_of(Descriptor(file, O_RDONLY), file);
}

/// A journal that is to be followed.
class Records {
 public:
  explicit Records(std::filesystem::path const& file) : path_(journal_of(file)), journal_(path_, O_RDONLY) {
    auto const got = read_some(journal_, bytes_of(header_), 0, path_);
    if (got != sizeof header_ || header_.name != Header().name || header_.crc != header_.own_crc())
      throw EnvironmentError(
          fmt::format("'{}' is damaged, or no journal of this version of the program: '{}' "
                      "cannot be led back to where it was whole",
                      path_.string(), file.string()));
    std::uint64_t const count = (length_of(journal_, path_) - sizeof header_) / sizeof(Record);
    std::uint64_t const pages = header_.length / page_size + (header_.length % page_size > 0);
    for (std::uint64_t number = 0; number < count; ++number)
      if (auto const record = read(number);
          record.number == number && record.crc == record.own_crc() && record.page < pages)
        place_.emplace(record.page, number);
  }

  std::uint64_t length() const { return header_.length; }

  /// Whether the file, with its pages undone, is what it was.
  bool lead_back(Descriptor const& target, std::filesystem::path const& file) const {
    auto const pages = length_of(target, file) / page_size + 1 + place_.size();
    if (header_.length > pages * page_size)
      return false;
    PageDigest digest;
    digest.take(target, header_.length, file);
    for (auto const& [page, number] : place_)
      digest.take(page, read(number).bytes);
    return digest.value() == header_.digest;
  }

  void undo(Descriptor const& target, std::filesystem::path const& file) const {
    for (auto const& [page, number] : place_) {
      auto const record = read(number);
      std::uint64_t const offset = page * page_size, size = std::min(page_size, header_.length - offset);
      write_all(target, std::span(record.bytes).first(size), offset, file);
    }
    cut(target, header_.length, file);
    sync(target, file);
  }

 private:
  Record read(std::uint64_t number) const {
    Record record;
    read_some(journal_, bytes_of(record), offset_of_record(number), path_);
    return record;
  }

  std::filesystem::path path_;
  Descriptor journal_;
  Header header_;
  std::map<std::uint64_t, std::uint64_t> place_; ///< of a page's record
};

} // namespace

UndoJournal::UndoJournal(std::filesystem::path file, std::uint64_t length)
    : file_(std::move(file)), source_(file_, O_RDONLY) {
  digest_.take(source_, length, file_);
  begin({});
}

UndoJournal::UndoJournal(std::filesystem::path file) : UndoJournal(file, length_of(file)) {}

void UndoJournal::begin(std::unordered_set<std::uint64_t> const& pages) {
  sync(source_, file_);
  auto const path = journal_of(file_), fresh = std::filesystem::path(path).concat(".new");
  Descriptor journal(fresh, O_WRONLY | O_CREAT | O_TRUNC);
  flock(journal.get(),
        LOCK_EX | LOCK_NB); // nobody else has it open; where there are no locks, none is waited for
  Header header{.length = digest_.length(), .digest = digest_.value()};
  header.crc = header.own_crc();
  write_all(journal, bytes_of(header), fresh);
  save(pages, journal, 0);
  sync(journal, fresh);
  replace(fresh, path);
  journal_ = std::move(journal);
  saved_ = pages;
  changing_.clear(), appended_.clear();
}

void UndoJournal::renew() {
  if (failed_)
    throw EnvironmentError(fmt::format("cannot write '{}': an earlier write failed", file_.string()));
  failed_ = true; // until all of it is done
  auto const before = digest_.length(), now = length_of(source_, file_);
  digest_.take(source_, now, before / page_size, now / page_size + 1, file_);
  std::unordered_set<std::uint64_t> likely;
  for (auto const page : changing_)
    if (page * page_size < now) {
      digest_.take(source_, now, page, page + 1, file_);
      likely.insert(page);
    }
  begin(likely);
  failed_ = false;
}

void UndoJournal::save(std::unordered_set<std::uint64_t> const& pages, Descriptor const& journal,
                       std::uint64_t first_record) const {
  constexpr std::size_t at_once = 64;
  std::vector<Record> records;
  records.reserve(std::min(at_once, pages.size()));
  auto const write = [&] {
    auto const* bytes = reinterpret_cast<char const*>(records.data());
    write_all(journal, {bytes, records.size() * sizeof(Record)}, offset_of_record(first_record),
              journal_of(file_));
    first_record += records.size();
    records.clear();
  };
  for (auto const page : pages) {
    auto& record = records.emplace_back(Record{.number = first_record + records.size(), .page = page});
    read_some(source_, record.bytes, page * page_size, file_); // the rest of a short last page is 0
    record.crc = record.own_crc();
    if (records.size() == at_once)
      write();
  }
  write();
}

void UndoJournal::protect(std::uint64_t offset, std::uint64_t size) {
  if (failed_)
    throw EnvironmentError(fmt::format("cannot write '{}': an earlier write failed", file_.string()));
  std::unordered_set<std::uint64_t> fresh;
  for (std::uint64_t page = offset / page_size; page * page_size < offset + size; ++page) {
    bool const was_there = page * page_size < digest_.length();
    if (was_there || !appended_.insert(page).second)
      changing_.insert(page);
    if (was_there && !saved_.contains(page))
      fresh.insert(page);
  }
  if (fresh.empty())
    return;
  failed_ = true; // until all of it is done
  save(fresh, journal_, saved_.size());
  sync(journal_, journal_of(file_));
  saved_.merge(fresh);
  failed_ = false;
}

void UndoJournal::protect_beyond(std::uint64_t length) {
  if (length < digest_.length())
    protect(length, digest_.length() - length);
}

bool UndoJournal::exists(std::filesystem::path const& file) {
  return std::filesystem::exists(journal_of(file));
}

void UndoJournal::wait_for_writer(std::filesystem::path const& file) {
  try {
    if (exists(file))
      FileLock(journal_of(file), FileLock::Kind::shared, FileLock::usual_patience(FileLock::Kind::exclusive));
  } catch (EnvironmentError const&) {
    if (exists(file)) // not taken away meanwhile
      throw;
  }
}

void UndoJournal::roll_back(std::filesystem::path const& file) {
  if (!exists(file))
    return;
  Records const records(file);
  Descriptor const target(file, O_RDWR);
  if (!records.lead_back(target, file))
    throw EnvironmentError(
        fmt::format("'{}' or its journal '{}' is damaged: with what is there it cannot be led back to where "
                    "it was whole",
                    file.string(), journal_of(file).string()));
  records.undo(target, file);
}

void UndoJournal::discard(std::filesystem::path const& file) {
  std::error_code error;
  std::filesystem::remove(journal_of(file), error);
  if (!error)
    std::filesystem::remove(journal_of(file).concat(".new"), error);
  if (error)
    throw EnvironmentError(fmt::format("cannot remove '{}': {}", journal_of(file).string(), error.message()));
  sync_directory_of(file);
}

} // namespace mesobridge::workflows
