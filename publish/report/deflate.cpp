// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/deflate.hpp"

#include <zlib.h>

#include <stdexcept>

#include "oracle/records/text.hpp"

namespace gonogo::oracle::report {

std::string packed(std::string_view bytes) {
  constexpr int kRaw = -15;  // window bits of a stream without header
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("the memory for packing the report is missing");
  }
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  std::string in(bytes);  // zlib's interface takes bytes that it could write to
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  if (end != Z_STREAM_END) throw std::runtime_error("the report cannot be packed");
  return base64(out);
}

}  // namespace gonogo::oracle::report
