// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vectors of a corpus folder. A vector is read when it is asked for; what is kept is the text.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "checker/record.hpp"

namespace gonogo::checker {

using Readings = std::map<std::string, std::string>;

struct ExpectedAlarm {
  std::string kind;
  long block = 0;
};

// What must come of a program.
struct Expectation {
  enum class Ending { end, alarm, not_covered };
  Readings when;
  bool is_silent = false;       // no text states it
  bool has_others = false;      // other outcomes are right, too, and not stated
  std::vector<Record> records;  // the motions, without the record `end`
  Ending ending = Ending::end;
  Position end;                       // Ending::end
  std::vector<ExpectedAlarm> any_of;  // Ending::alarm
};

struct Vector {
  std::string id;
  std::string dialect;
  std::vector<std::string> features;
  Json profile;
  std::string program;  // bytes
  std::vector<Expectation> expect;
  std::string cycle = {};
  std::vector<std::string> clauses = {};
};

// What a selection asks of a vector.
struct Topic {
  std::string dialect;
  std::string cycle;
  std::vector<std::string> clauses;
};

class Corpus {
 public:
  struct File {
    std::string name;  // relative to the folder
    std::string text;
  };

  // Reads manifest and files; throws Fault for what cannot be read or is not a corpus.
  explicit Corpus(std::string folder);

  const std::string& version() const { return version_; }
  // Over names, sizes and bytes of the files, as results files name it.
  const std::string& sha256() const { return sha256_; }
  const std::vector<std::string>& retired() const { return retired_; }
  // Those below vectors/, by name.
  const std::vector<File>& files() const { return files_; }
  // What does not hold of the corpus as a whole: sentences.
  const std::vector<std::string>& faults() const { return faults_; }

  bool has(const std::string& id) const { return cases_.contains(id); }
  // For an id that is there.
  const Json& profile_of(const std::string& id) const {
    return groups_[cases_.at(id).group].profile;
  }
  // Id and topic of every vector, by id.
  void for_each(const std::function<void(const std::string& id, const Topic& topic)>& visit) const;
  // For an id that is there. Throws Fault for a vector that cannot be read.
  Vector read(const std::string& id) const;

 private:
  struct Group {
    Topic topic;
    std::vector<std::string> features;
    Json profile;
  };
  struct Place {
    std::size_t file = 0;
    std::size_t group = 0;
    std::size_t begin = 0, end = 0;  // in the file's text
  };
  void read_manifest(std::vector<std::string>& listed);
  void index(std::size_t file);

  std::string folder_;
  std::string version_;
  std::string sha256_;
  std::vector<std::string> retired_;
  std::vector<std::string> faults_;
  std::vector<File> files_;
  std::vector<Group> groups_;
  std::map<std::string, Place> cases_;
};

// Throws Fault.
std::string file_text(const std::string& path);
// The NC text; base64 is decoded. Throws Fault.
std::string program_bytes(const Json& program);

}  // namespace gonogo::checker
