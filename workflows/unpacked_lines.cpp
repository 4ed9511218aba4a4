#include "workflows/unpacked_lines.hpp"
#include "md/error.hpp"
#include <boost/iostreams/device/file.hpp>
#include <boost/iostreams/filter/bzip2.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filter/zstd.hpp>
#include <fstream>

namespace mesobridge::workflows {

namespace {

namespace io = boost::iostreams;

std::string first_bytes(std::filesystem::path const& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw InputError(fmt::format("'{}' cannot be read", file.string()));
  std::string bytes(6, '\0');
  in.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(std::size_t(in.gcount()));
  return bytes;
}

/// Puts what unpacks the bytes before the file; false: they are not packed.
bool push_unpacker(io::filtering_istream& in, std::string_view bytes) {
  if (bytes.starts_with("\x1f\x8b"))
    in.push(io::gzip_decompressor());
  else if (bytes.starts_with("\x28\xb5\x2f\xfd"))
    in.push(io::zstd_decompressor());
  else if (bytes.starts_with("BZh"))
    in.push(io::bzip2_decompressor());
  else if (bytes.starts_with("\xfd"
                             "7zXZ"))
    in.push(io::lzma_decompressor());
  else
    return false;
  return true;
}

} // namespace

UnpackedLines::UnpackedLines(std::filesystem::path const& file) : file_(file) {
  packed_ = push_unpacker(in_, first_bytes(file));
  constexpr std::streamsize buffer = 1 << 16;
  in_.push(io::file_source(file.string(), std::ios::binary), buffer);
  in_.exceptions(std::ios::badbit);
}

bool UnpackedLines::next(std::string& line) {
  try {
    return std::getline(in_, line) && !in_.eof();
  } catch (io::gzip_error const& error) {
    cut_ = error.error() == io::gzip::bad_footer || error.error() == io::gzip::bad_header ||
           (error.error() == io::gzip::zlib_error && error.zlib_error_code() == io::zlib::buf_error);
  } catch (io::bzip2_error const& error) {
    cut_ = error.error() == io::bzip2::unexpected_eof;
  } catch (io::lzma_error const& error) {
    cut_ = error.error() == io::lzma::buf_error;
  } catch (std::ios_base::failure const&) {
  }
  if (cut_)
    return false; // the bytes end before their time
  throw InputError(fmt::format("'{}': its packed bytes are damaged", file_.string()));
}

} // namespace mesobridge::workflows
