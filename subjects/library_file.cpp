// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/library_file.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "oracle/records/text.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {
namespace {

using GetSubject = const gonogo_subject_v1* (*)(std::uint32_t);

constexpr const char* kEntry = "gonogo_get_subject";

// What the loader says last; never null after a failure.
std::string loader_words() {
  const char* words = dlerror();
  return words == nullptr ? "no reason was given" : visible(words);
}

void* load(const std::string& path) {
  if (void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) return library;
  throw SubjectUnusable(fmt::format(
      "The library {} cannot be loaded ({}). Build it as a shared library for this machine "
      "(-shared -fPIC), with every library that it needs.",
      path, loader_words()));
}

GetSubject entry_of(void* library, const std::string& path) {
  if (void* symbol = dlsym(library, kEntry)) return reinterpret_cast<GetSubject>(symbol);
  throw SubjectUnusable(
      fmt::format("The library {} exports no function {}. Include gonogo/subject.h, define the "
                  "function that it declares (in C++ the header makes it extern \"C\"), and do not "
                  "hide it.",
                  path, kEntry));
}

}  // namespace

std::string library_path(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const std::string absolute = fs::absolute(path, error).lexically_normal().string();
  if (error || !fs::is_regular_file(absolute, error)) {
    throw SubjectUnusable(fmt::format(
        "There is no library {}. Name the file of a shared library by its path, as lib:./acme.so.",
        path));
  }
  if (access(absolute.c_str(), R_OK) != 0) {
    throw SubjectUnusable(
        fmt::format("The library {} cannot be read; give yourself the permission.", path));
  }
  return absolute;
}

const gonogo_subject_v1& load_library(const std::string& path) {
  const std::string absolute = library_path(path);
  const gonogo_subject_v1* subject = entry_of(load(absolute), absolute)(GONOGO_SUBJECT_ABI);
  if (subject != nullptr) return *subject;
  throw SubjectUnusable(
      fmt::format("The library {} has no C interface of version {} or older. Build it with the "
                  "header gonogo/subject.h of this release, or use a newer gonogo.",
                  absolute, GONOGO_SUBJECT_ABI));
}

}  // namespace gonogo::oracle
