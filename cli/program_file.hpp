// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files named on the command line.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "grammar/line_source.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {
struct CampaignOptions;
}  // namespace gonogo::oracle

namespace gonogo::cli {

// Wrong use of the program: exit 2, with what to do instead.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws UsageError where there is no dialect of that name.
void check_dialect_name(const std::string& dialect);

inline constexpr const char* kNcProgram = "an NC program, or - for standard input";

// An NC program as a stream; "-" is standard input. `kind` says what the file ought to be.
class ProgramFile {
 public:
  explicit ProgramFile(const std::string& path, const char* kind = kNcProgram);
  ~ProgramFile();
  ProgramFile(const ProgramFile&) = delete;
  ProgramFile& operator=(const ProgramFile&) = delete;

  // The name for diagnostics.
  const std::string& name() const { return name_; }
  // The size of a regular file; -1 for a pipe.
  long long size() const { return size_; }
  grammar::ByteSource& bytes() { return *bytes_; }
  // What cannot be read twice, as a pipe, is copied into a temporary file first. Throws UsageError;
  // what never ends does not fill the disk.
  void keep();
  // The program with the subroutines that stand in files beside it (cli/called_files.hpp). Tells
  // the user which. REQUIRES: keep() was called.
  void add_called_files(const std::string& dialect);
  int descriptor() const { return descriptor_; }

 private:
  // Reads from a temporary file with all of `bytes` from here on. Throws UsageError.
  void read_copy_of(grammar::ByteSource& bytes);

  std::string name_;
  int descriptor_ = -1;
  long long size_ = -1;
  std::unique_ptr<grammar::ByteSource> bytes_;
};

inline constexpr std::size_t kMostBytes = std::size_t{1} << 30;
// All of `bytes`. Throws UsageError, with the name, where there are more than `limit`.
std::string read_all(grammar::ByteSource& bytes, const std::string& name,
                     std::size_t limit = kMostBytes);
std::string read_file(const std::string& path, const char* kind = kNcProgram,
                      std::size_t limit = kMostBytes);

// What the options --dialect, --profile and --reading say together.
struct ProfileOptions {
  std::string dialect;
  std::string file;
  std::vector<std::string> readings;  // "k=v"
};
reference::Profile load_profile(const ProfileOptions& options);
// The certifier's machine of a file, with the keys that the file sets. Throws UsageError.
void load_machine(oracle::CampaignOptions& campaign, const std::string& dialect,
                  const std::string& file);
// Throws UsageError for a reading that is given twice.
void check_readings_once(const std::vector<std::string>& readings);

}  // namespace gonogo::cli
