// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corpus inside the program. This program brings a definition of its own, as the relocatable one
// does, so that the linker leaves the empty one out.
#include <gtest/gtest.h>
#include <zlib.h>

#include <vector>

#include "corpus/io/corpus.hpp"
#include "corpus/io/embedded.hpp"

namespace gonogo {
namespace {

constexpr std::string_view kManifest =
    R"({"format":1,"version":"2026.1.0","license":"CC0-1.0","files":["vectors/gsk988ta/g94.json"],"retired":[]})";
constexpr std::string_view kVectors =
    R"({"format":1,"corpus":"2026.1.0","dialect":"gsk988ta",
"cycle":"g94","groups":[{"gid":"t.a","features":["g94"],"clauses":["GSK-G94-01"],"profile":{},
"cases":[{"id":"t.a.000001","comment":"one","program":"G00 X2\n",
"expect":[{"records":[{"k":"end","to":{"x":"0"}}]}],
"tags":{"tway":[],"sign":[]},"provenance":"hand"}]}]})";

// A gzip file of the text.
std::string gzipped(std::string text) {
  constexpr int kGzip = 15 + 16;
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, kGzip, 9, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(text.data());
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string carried_error(const std::string& gzip) {
  try {
    oracle::embedded_text({"vectors/x.json", gzip});
  } catch (const oracle::CorpusError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

namespace oracle {

std::span<const EmbeddedFile> embedded_corpus() {
  static const std::string manifest = gzipped(std::string(kManifest));
  static const std::string vectors = gzipped(std::string(kVectors));
  static const EmbeddedFile files[] = {{"manifest.json", manifest},
                                       {"vectors/gsk988ta/g94.json", vectors}};
  return files;
}

}  // namespace oracle

namespace {

TEST(Carried, TextsOfEveryLengthComeBack) {
  for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 1000000U}) {
    std::string text(size, ' ');
    for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(i * i % 251);
    EXPECT_EQ(oracle::embedded_text({"x", gzipped(text)}), text) << size;
  }
}

TEST(Carried, ADamagedFileIsRefused) {
  const std::string good = gzipped(std::string(kVectors));
  const std::string sentence =
      "carried:vectors/x.json is damaged: the program file is not as it was built.";
  EXPECT_EQ(carried_error(good), "no error");
  EXPECT_EQ(carried_error(""), sentence);
  EXPECT_EQ(carried_error("no gzip at all"), sentence);
  for (std::size_t length = 1; length < good.size(); ++length) {
    EXPECT_EQ(carried_error(good.substr(0, length)), sentence) << length;
  }
  std::string other = good;
  other[good.size() / 2] =
      static_cast<char>(other[good.size() / 2] ^ 1);  // its sum no longer holds
  EXPECT_EQ(carried_error(other), sentence);
}

TEST(Carried, ACorpusIsReadAsFromAFolder) {
  const oracle::Corpus corpus{std::string(oracle::kEmbeddedFolder)};
  EXPECT_EQ(corpus.version(), "2026.1.0");
  EXPECT_EQ(corpus.files(), std::vector<std::string>{"vectors/gsk988ta/g94.json"});
  EXPECT_EQ(corpus.file_bytes(), std::vector<std::uint64_t>{kVectors.size()});
  std::vector<std::string> ids;
  corpus.for_each([&](const oracle::Case& test) { ids.push_back(test.id); });
  EXPECT_EQ(ids, std::vector<std::string>{"t.a.000001"});
}

TEST(Carried, AFileThatIsNotCarried) {
  try {
    oracle::read_vector_file("carried:/vectors/rs274/none.json");
    FAIL();
  } catch (const oracle::CorpusError& error) {
    EXPECT_STREQ(error.what(), "This program carries no carried:/vectors/rs274/none.json.");
  }
}

}  // namespace
}  // namespace gonogo
