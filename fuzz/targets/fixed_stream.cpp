// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/fixed_stream.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "fuzz/targets/target.hpp"

// The structured mutator of the target, which it has for its engine.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed);
// Targets that read NC text cross two of them; decisions are not crossed.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomCrossOver(
    const std::uint8_t* one, std::size_t one_size, const std::uint8_t* other,
    std::size_t other_size, std::uint8_t* out, std::size_t most, unsigned int seed);

namespace gonogo::fuzz {
namespace {

// The distributions of the standard library differ from one to another; the engine does not.
using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

unsigned int structured_seed(Random& random) {
  const auto seed = static_cast<unsigned int>(random());
  return is_turn_of_engine(seed) ? seed + 1 : seed;
}

Bytes random_bytes(Random& random, std::size_t size) {
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

// What an engine does of its own: a byte becomes another one, goes, or comes in.
void change_bytes(Random& random, std::size_t most, Bytes& bytes) {
  const auto byte = static_cast<std::uint8_t>(random());
  const std::size_t kind = below(random, 3);
  const auto at = static_cast<std::ptrdiff_t>(below(random, bytes.size() + 1));
  if (kind == 0 && bytes.size() < most) {
    bytes.insert(bytes.begin() + at, byte);
  } else if (at < std::ssize(bytes)) {
    if (kind == 1) bytes.erase(bytes.begin() + at);
    if (kind != 1) bytes[static_cast<std::size_t>(at)] = byte;
  }
}

void change_structure(Random& random, std::size_t most, Bytes& bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(most);
  bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), size, most, structured_seed(random)));
}

std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

Bytes read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void try_input(const Bytes& bytes) {
  static const char* const kFile = std::getenv("GONOGO_FUZZ_INPUT");
  if (kFile != nullptr) {
    std::ofstream(kFile, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  }
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

}  // namespace

Bytes FixedStream::input(std::uint64_t number) const {
  constexpr std::size_t kMostChanges = 5;
  Random random(seed_ * 1'000'003 + number);
  const bool are_texts = LLVMFuzzerCustomCrossOver != nullptr;
  // Any bytes are decisions, but hardly any are a program.
  const bool from_nothing = stored_.empty() || (!are_texts && below(random, 2) == 0);
  Bytes bytes = from_nothing ? random_bytes(random, are_texts ? 0 : most_bytes_)
                             : stored_[below(random, stored_.size())];
  bytes.resize(std::min(bytes.size(), most_bytes_));
  if (are_texts && !stored_.empty() && below(random, 4) == 0) {
    const Bytes& other = stored_[below(random, stored_.size())];
    Bytes both(most_bytes_);
    both.resize(LLVMFuzzerCustomCrossOver(bytes.data(), bytes.size(), other.data(), other.size(),
                                          both.data(), most_bytes_, structured_seed(random)));
    bytes = std::move(both);
  }
  for (std::size_t left = 1 + below(random, kMostChanges); left > 0; --left) {
    const auto change = below(random, 4) == 0 ? change_bytes : change_structure;
    change(random, most_bytes_, bytes);
  }
  return bytes;
}

void run_stream_if_asked(int argc, const char* const* argv) {
  const char* const words = std::getenv("GONOGO_FUZZ_STREAM");
  if (words == nullptr) return;
  unsigned long long seed = 0;
  unsigned long long inputs = 0;
  unsigned long long most_bytes = 0;
  if (std::sscanf(words, "%llu %llu %llu", &seed, &inputs, &most_bytes) != 3 || most_bytes == 0) {
    std::fprintf(stderr, "GONOGO_FUZZ_STREAM: write \"SEED INPUTS MOST_BYTES\"\n");
    std::exit(2);
  }
  std::vector<Bytes> stored;
  for (int i = 1; i < argc; ++i) {
    for (const auto& path : files_below(argv[i])) stored.push_back(read_bytes(path));
  }
  for (const Bytes& bytes : stored) try_input(bytes);
  const std::size_t count = stored.size();
  const FixedStream stream(std::move(stored), seed, most_bytes);
  for (std::uint64_t number = 0; number < inputs; ++number) try_input(stream.input(number));
  std::printf("%zu stored inputs and %llu of the stream\n", count, inputs);
  std::exit(0);
}

}  // namespace gonogo::fuzz
