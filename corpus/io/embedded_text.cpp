// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <new>

#include "corpus/io/corpus.hpp"
#include "corpus/io/embedded.hpp"

namespace gonogo::oracle {

std::string embedded_text(const EmbeddedFile& file) {
  constexpr int kGzip = 15 + 16;  // window bits, of a stream with gzip's header
  z_stream stream{};
  if (inflateInit2(&stream, kGzip) != Z_OK) throw std::bad_alloc();
  std::string in(file.gzip);  // zlib's interface takes bytes that it could write to
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  std::string text;
  std::array<char, 1 << 16> piece;
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) {
    throw CorpusError(fmt::format("{}{} is damaged: the program file is not as it was built.",
                                  kEmbeddedFolder, file.name));
  }
  return text;
}

}  // namespace gonogo::oracle
