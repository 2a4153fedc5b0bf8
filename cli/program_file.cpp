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

void ProgramFile::keep() {
  constexpr std::size_t kMostCopied = std::size_t{1} << 30;
  if (size_ < 0) {
    std::FILE* const copy = std::tmpfile();
    bool copied = copy != nullptr;
    std::array<char, 1 << 16> chunk;
    std::size_t size = 0;
    while (std::size_t count = copied ? bytes_->read(chunk.data(), chunk.size()) : 0) {
      size += count;
      if (size > kMostCopied) {
        std::fclose(copy);
        throw UsageError(fmt::format("{} does not end within {} bytes. Name a file instead.", name_,
                                     kMostCopied));
      }
      copied = std::fwrite(chunk.data(), 1, count, copy) == count;
    }
    copied = copied && std::fflush(copy) == 0;
    if (copied) descriptor_ = ::dup(::fileno(copy));
    const int fault = errno;
    if (copy != nullptr) std::fclose(copy);
    if (!copied || descriptor_ < 0) {
      throw UsageError(
          fmt::format("{} cannot be kept in a temporary file: {}. Name a file instead.", name_,
                      std::strerror(fault)));
    }
  }
  bytes_ = std::make_unique<grammar::FileSource>(descriptor_);
}

void ProgramFile::add_called_files() {
  if (size_ <= 0 || size_ > kMostWithCalls) return;
  const std::string alone = read_file(name_);
  std::string program = alone;
  cli::add_called_files(name_, program);
  if (program == alone) return;
  std::FILE* const whole = std::tmpfile();
  const bool written = whole != nullptr &&
                       std::fwrite(program.data(), 1, program.size(), whole) == program.size() &&
                       std::fflush(whole) == 0;
  const int descriptor = written ? ::dup(::fileno(whole)) : -1;
  const int fault = errno;
  if (whole != nullptr) std::fclose(whole);
  if (descriptor < 0) {
    throw UsageError(fmt::format("{} and its subroutines cannot be kept in a temporary file: {}.",
                                 name_, std::strerror(fault)));
  }
  ::close(descriptor_);
  descriptor_ = descriptor;
  bytes_ = std::make_unique<grammar::FileSource>(descriptor_);
}

std::string read_file(const std::string& path, const char* kind, std::size_t limit) {
  ProgramFile file(path, kind);
  std::string text;
  std::array<char, 1 << 16> chunk;
  while (std::size_t count = file.bytes().read(chunk.data(), chunk.size())) {
    text.append(chunk.data(), count);
    if (text.size() > limit)
      throw UsageError(fmt::format("{} is larger than {} bytes.", path, limit));
  }
  return text;
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
  throw UsageError(fmt::format("There is no dialect {}. Choose one of {}.", dialect,
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
    if (reference::find_dialect(options.dialect) == nullptr) {
      std::vector<std::string> names;
      for (const auto& dialect : reference::dialects()) names.emplace_back(dialect.name);
      throw UsageError(
          fmt::format("There is no dialect \"{}\". {}Write one of: {}.", options.dialect,
                      reference::did_you_mean(reference::nearest_word(options.dialect, names)),
                      reference::dialect_names()));
    }
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
