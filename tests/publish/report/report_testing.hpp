// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the report share.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <string>

#include "oracle/records/text.hpp"
#include "publish/report/escape.hpp"
#include "publish/report/path.hpp"

namespace gonogo::oracle::report {

inline Motion line(Point3 from, Point3 to, bool rapid = false) {
  Motion motion;
  motion.rapid = rapid;
  motion.points = {from, to};
  return motion;
}

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

// What packed() packed.
inline std::string unpacked(const std::string& text) {
  std::string bytes = decode_base64(text).value();
  std::string out(1 << 24, '\0');
  z_stream stream{};
  inflateInit2(&stream, -15);
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  const int end = inflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  inflateEnd(&stream);
  return end == Z_STREAM_END ? out : std::string();
}

}  // namespace gonogo::oracle::report
