// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program_file.hpp"
#include "cli/called_files.hpp"
#include "reference/nearest_word.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <set>

#include "campaign/campaign.hpp"
#include "grammar/file_source.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

// Whether a FIFO of which nothing has been read has a writer, or something to be read.
bool has_writer(int descriptor) {
  std::array<int, 2> copy{};
  if (::pipe2(copy.data(), O_CLOEXEC) != 0) return true;
  const bool has = ::tee(descriptor, copy[1], 1, SPLICE_F_NONBLOCK) != 0;
  ::close(copy[0]);
  ::close(copy[1]);
  return has;
}

// A FIFO without a writer would be waited for without end.
bool has_nobody_behind(int descriptor) {
  constexpr int kWaitMs = 5000;
  pollfd waiting{descriptor, POLLIN, 0};
  return ::poll(&waiting, 1, kWaitMs) == 0 && !has_writer(descriptor);
}

// A device that is no terminal does not end, except the one of no bytes.
bool is_endless(const struct stat& status, int descriptor) {
  struct stat null {};
  const bool is_null = ::stat("/dev/null", &null) == 0 && null.st_rdev == status.st_rdev;
  return S_ISBLK(status.st_mode) ||
         (S_ISCHR(status.st_mode) && !is_null && ::isatty(descriptor) == 0);
}

}  // namespace

ProgramFile::ProgramFile(const std::string& path, const char* kind)
    : name_(path == "-" ? "<stdin>" : path) {
  descriptor_ =
      path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) {
    throw UsageError(
        fmt::format("{} cannot be opened: {}. Name {}.", path, std::strerror(errno), kind));
  }
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0) {
    if (S_ISDIR(status.st_mode)) {
      throw UsageError(fmt::format("{} is a folder. Name {}.", path, kind));
    }
    if (is_endless(status, descriptor_)) {
      throw UsageError(fmt::format("{} is a device. Name {}.", path, kind));
    }
    if (S_ISFIFO(status.st_mode) && path != "-" && has_nobody_behind(descriptor_)) {
      throw UsageError(fmt::format("Nobody writes to {}. Name {}.", path, kind));
    }
    if (S_ISREG(status.st_mode)) size_ = status.st_size;
  }
  // Only the opening was not to wait.
  if (descriptor_ != STDIN_FILENO) ::fcntl(descriptor_, F_SETFL, 0);
  bytes_ = std::make_unique<grammar::DescriptorSource>(descriptor_);
}

ProgramFile::~ProgramFile() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

void ProgramFile::read_copy_of(grammar::ByteSource& bytes) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> copy(std::tmpfile(), std::fclose);
  bool copied = copy != nullptr;
  std::array<char, 1 << 16> chunk;
  std::size_t size = 0;
  while (std::size_t count = copied ? bytes.read(chunk.data(), chunk.size()) : 0) {
    size += count;
    if (size > kMostBytes) {
      throw UsageError(
          fmt::format("{} does not end within {} bytes. Name a file instead.", name_, kMostBytes));
    }
    copied = std::fwrite(chunk.data(), 1, count, copy.get()) == count;
  }
  const int descriptor = copied && std::fflush(copy.get()) == 0 ? ::dup(::fileno(copy.get())) : -1;
  if (descriptor < 0) {
    throw UsageError(
        fmt::format("{} cannot be kept in a temporary file: {}.", name_, std::strerror(errno)));
  }
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
  descriptor_ = descriptor;
  size_ = static_cast<long long>(size);
  bytes_ = std::make_unique<grammar::FileSource>(descriptor_);
}

void ProgramFile::keep() {
  if (size_ < 0) {
    read_copy_of(*bytes_);
  } else {
    bytes_ = std::make_unique<grammar::FileSource>(descriptor_);
  }
}

void ProgramFile::add_called_files(const std::string& dialect) {
  if (size_ > static_cast<long long>(kMostWithCalls)) return;
  grammar::FileSource alone(descriptor_);
  std::string program = read_all(alone, name_);
  if (!cli::add_called_files(dialect, name_, program)) return;
  grammar::MemorySource whole(program);
  read_copy_of(whole);
}

std::string read_all(grammar::ByteSource& bytes, const std::string& name, std::size_t limit) {
  std::string text;
  std::array<char, 1 << 16> chunk;
  while (std::size_t count = bytes.read(chunk.data(), chunk.size())) {
    text.append(chunk.data(), count);
    if (text.size() > limit)
      throw UsageError(fmt::format("{} is larger than {} bytes.", name, limit));
  }
  return text;
}

std::string read_file(const std::string& path, const char* kind, std::size_t limit) {
  ProgramFile file(path, kind);
  return read_all(file.bytes(), path, limit);
}

namespace {

reference::Profile checked(reference::ProfileResult result, const std::string& file) {
  if (auto* error = std::get_if<reference::ProfileError>(&result)) {
    throw UsageError(file.empty() ? error->message : fmt::format("{}: {}", file, error->message));
  }
  return std::get<reference::Profile>(std::move(result));
}

std::string profile_text(const std::string& file) {
  return read_file(file, "a machine profile, TOML or JSON", std::size_t{1} << 20);
}

bool is_json(const std::string& file) {
  return file.ends_with(".json");
}

reference::Profile profile_of(const std::string& text, const ProfileOptions& options) {
  const std::string_view unnamed =
      options.dialect.empty() ? reference::kUnnamedDialect : std::string_view(options.dialect);
  reference::Profile profile =
      checked(is_json(options.file) ? reference::profile_from_json(text, unnamed)
                                    : reference::profile_from_toml(text, unnamed),
              options.file);
  if (!options.dialect.empty() && options.dialect != profile.dialect) {
    throw UsageError(fmt::format("{} is a profile of dialect {}, but --dialect says {}.",
                                 options.file, profile.dialect, options.dialect));
  }
  return profile;
}

}  // namespace

void check_dialect_name(const std::string& dialect) {
  if (reference::find_dialect(dialect) != nullptr) return;
  std::vector<std::string> names;
  for (const reference::Dialect& one : reference::dialects()) names.emplace_back(one.name);
  throw UsageError(fmt::format("There is no dialect \"{}\". {}Write one of: {}.", dialect,
                               reference::did_you_mean(reference::nearest_word(dialect, names)),
                               reference::dialect_names()));
}

void check_readings_once(const std::vector<std::string>& readings) {
  std::set<std::string> names;
  for (const std::string& choice : readings) {
    const std::string name = choice.substr(0, choice.find('='));
    if (!names.insert(name).second) {
      throw UsageError(fmt::format("--reading {} is given twice; `any` admits every value.", name));
    }
  }
}

void load_machine(oracle::CampaignOptions& campaign, const std::string& dialect,
                  const std::string& file) {
  const std::string text = profile_text(file);
  campaign.profile = profile_of(text, {dialect, file, {}});
  campaign.profile_keys =
      is_json(file) ? reference::keys_of_json(text) : reference::keys_of_toml(text);
}

reference::Profile load_profile(const ProfileOptions& options) {
  reference::Profile profile;
  if (!options.file.empty()) {
    profile = profile_of(profile_text(options.file), options);
  } else if (options.dialect.empty()) {
    throw UsageError(
        fmt::format("Name the dialect: --dialect and one of {}.", reference::dialect_names()));
  } else {
    check_dialect_name(options.dialect);
    profile = checked(reference::default_profile(options.dialect), "");
  }
  check_readings_once(options.readings);
  for (const std::string& choice : options.readings) {
    const std::size_t equals = choice.find('=');
    if (equals == std::string::npos) {
      throw UsageError(fmt::format("--reading {} is not of the form key=value.", choice));
    }
    auto error =
        reference::set_reading(profile, choice.substr(0, equals), choice.substr(equals + 1));
    if (error) throw UsageError(error->message);
  }
  return profile;
}

}  // namespace gonogo::cli
