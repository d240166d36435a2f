#include "core/file.hpp"

#include <openssl/evp.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

std::string reason() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

fs::path temporary_beside(const fs::path& path) {
  fs::path name = path;
  name += ".part-" + std::to_string(::getpid());
  return name;
}

}  // namespace

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail_data(path.string(), "", "is a folder, not a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail_data(path.string(), "", "cannot be opened: " + reason());
  // One read where the size is known; what has none (a pipe, /proc) comes in pieces.
  std::string content;
  const auto size = fs::file_size(path, ignored);
  std::size_t filled = 0;
  content.resize(ignored ? 0 : static_cast<std::size_t>(size));
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  filled = static_cast<std::size_t>(in.gcount());
  while (in) {
    content.resize(std::max<std::size_t>(2 * content.size(), filled + 65536));
    in.read(content.data() + filled, static_cast<std::streamsize>(content.size() - filled));
    filled += static_cast<std::size_t>(in.gcount());
  }
  if (in.bad()) fail_data(path.string(), "", "cannot be read: " + reason());
  content.resize(filled);
  return content;
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  const fs::path temporary = temporary_beside(path);
  const auto fail = [&](const std::string& why) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    fail_data(path.string(), "", "cannot be written: " + why);
  };
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  if (!out) fail(reason());
  try {
    writer(out);
  } catch (...) {
    out.close();
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
  out.flush();
  if (!out) fail(reason());
  out.close();
  if (!out) fail(reason());
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) fail(error.message());
}

void write_file(const fs::path& path, std::string_view content) {
  write_file(path, [&](std::ostream& out) {
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_data(folder.string(), "", "folder cannot be made: " + error.message());
  if (!fs::is_directory(folder, error)) fail_data(folder.string(), "", "is a file, not a folder");
  const fs::path probe = temporary_beside(folder / ".probe");
  errno = 0;
  std::ofstream out(probe);
  const bool writable = static_cast<bool>(out);
  const std::string why = reason();
  out.close();
  fs::remove(probe, error);
  if (!writable) fail_data(folder.string(), "", "folder cannot be written to: " + why);
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
  static constexpr char hex[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += hex[digest[i] >> 4];
    text += hex[digest[i] & 15];
  }
  return text;
}

}  // namespace scanchor
