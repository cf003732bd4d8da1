#include "io/files/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

#include "io/files/error.h"

namespace sturm {

namespace {

constexpr int gzip_window = 15 + 16;  // zlib's largest window; 16 more make it a gzip file

/// Takes `bytes` through one of zlib's streams in pieces that its counters can hold.
template <class Step>
std::string pumped(z_stream& stream, std::string_view bytes, const Step& step) {
  std::string result;
  char piece[1 << 16];
  int state = Z_OK;
  while (state == Z_OK) {
    const std::size_t some = std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(some);
    stream.next_out = reinterpret_cast<Bytef*>(piece);
    stream.avail_out = sizeof piece;
    state = step(some == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    bytes.remove_prefix(some - stream.avail_in);
    result.append(piece, sizeof piece - stream.avail_out);
    if (state == Z_BUF_ERROR && stream.avail_out == 0) state = Z_OK;  // the piece is full, more follows
  }
  if (state != Z_STREAM_END)
    throw RuntimeFailure("zlib: " + std::string(stream.msg ? stream.msg : "the data is cut off"));
  return result;
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw RuntimeFailure("zlib: no memory");
  try {
    std::string file = pumped(stream, bytes, [&](int flush) { return deflate(&stream, flush); });
    deflateEnd(&stream);
    return file;
  } catch (...) {
    deflateEnd(&stream);
    throw;
  }
}

std::string gunzip(std::string_view file) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw RuntimeFailure("zlib: no memory");
  try {
    std::string bytes = pumped(stream, file, [&](int) { return inflate(&stream, Z_NO_FLUSH); });
    inflateEnd(&stream);
    return bytes;
  } catch (...) {
    inflateEnd(&stream);
    throw;
  }
}

}  // namespace sturm
