#include "io/files/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "io/files/error.h"

namespace sturm {

namespace {

/// Throws unless a function of OpenSSL's reported success: out of memory, or a configuration of the library that has no
/// SHA-256.
void require(int success) {
  if (success != 1) throw RuntimeFailure("OpenSSL cannot compute a SHA-256");
}

class Hash {
 public:
  Hash() { require(state_ && EVP_DigestInit_ex(state_.get(), EVP_sha256(), nullptr)); }

  void add(std::string_view bytes) { require(EVP_DigestUpdate(state_.get(), bytes.data(), bytes.size())); }

  std::string digest() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes;
    unsigned length = 0;
    require(EVP_DigestFinal_ex(state_.get(), bytes.data(), &length));
    std::string text;
    for (const unsigned char byte : std::span(bytes).first(length))
      text.append({"0123456789abcdef"[byte >> 4], "0123456789abcdef"[byte & 15]});
    return text;
  }

 private:
  struct Free {
    void operator()(EVP_MD_CTX* state) const { EVP_MD_CTX_free(state); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> state_{EVP_MD_CTX_new()};
};

}  // namespace

std::string sha256(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.digest();
}

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  Hash hash;
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
    hash.add({piece.data(), static_cast<std::size_t>(stream.gcount())});
  if (!stream.eof()) throw InputError(path.string(), "", "no readable file", "an input file");
  return hash.digest();
}

}  // namespace sturm
