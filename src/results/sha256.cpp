#include "coilwright/results/sha256.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <memory>
#include <span>
#include <stdexcept>
#include <system_error>
#include <vector>

namespace coilwright::results {
namespace {

constexpr std::size_t block_size = 1 << 20;

class Digest {
 public:
  Digest() { require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)); }
  void add(std::string_view bytes) { require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size())); }
  [[nodiscard]] std::string hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), &size));
    std::string text;
    for (const unsigned char byte : std::span(digest).first(size)) text += fmt::format("{:02x}", byte);
    return text;
  }

 private:
  static void require(int done) {
    if (done != 1) throw std::runtime_error("libcrypto cannot compute SHA-256");
  }
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_{EVP_MD_CTX_new(), &EVP_MD_CTX_free};
};

[[noreturn]] void refuse_to_read(const std::filesystem::path& path, const std::string& reason) {
  throw std::runtime_error(path.string() + ": cannot be read" + reason);
}

}  // namespace

std::string sha256(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.hexadecimal();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  Digest digest;
  std::ifstream file(path, std::ios::binary);
  for (std::vector<char> block(block_size); file;) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    digest.add({block.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (!file.eof()) refuse_to_read(path, "");
  return digest.hexadecimal();
}

bool holds_exactly(const std::filesystem::path& path, std::uintmax_t bytes, std::string_view sha256,
                   const std::function<void(std::string_view block)>& take) {
  const auto close_it = [](const int* file) { ::close(*file); };
  // Without waiting for whoever would write to a pipe.
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  const auto fail = [&] { refuse_to_read(path, ": " + std::generic_category().message(errno)); };
  if (file < 0 && errno != ENOENT && errno != ENOTDIR && errno != ELOOP && errno != ENXIO) fail();
  if (file < 0) return false;
  const std::unique_ptr<const int, decltype(close_it)> closed(&file, close_it);
  struct stat status {};
  if (::fstat(file, &status) != 0) fail();
  if (!S_ISREG(status.st_mode)) return false;
  if (static_cast<std::uintmax_t>(status.st_size) != bytes) return false;
  Digest digest;
  std::vector<char> block(block_size);
  ssize_t count = 0;
  while ((count = ::read(file, block.data(), block.size())) > 0) {
    const std::string_view read(block.data(), static_cast<std::size_t>(count));
    digest.add(read);
    if (take) take(read);
  }
  if (count < 0) fail();
  return digest.hexadecimal() == sha256;
}

}  // namespace coilwright::results
