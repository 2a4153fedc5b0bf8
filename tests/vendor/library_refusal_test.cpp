// SPDX-License-Identifier: GPL-3.0-or-later
//
// Libraries that are no subject: a sentence each that names the library and says what to do.
#include <cstdlib>
#include <fstream>

#include "libraries.hpp"
#include "subjects/library_file.hpp"

namespace gonogo::oracle {
namespace {

std::string refusal_of(const std::string& path, const Limits& limits = patient_limits()) {
  try {
    check_library(path, limits, GONOGO_PROGRAM);
  } catch (const SubjectUnusable& error) {
    return error.what();
  }
  return "no refusal";
}

// The sentence names the file and holds `words`.
void expect_refusal(const std::string& variant, const std::string& words) {
  const std::string refusal = refusal_of(library(variant));
  EXPECT_NE(refusal.find("library_" + variant + ".so"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(words), std::string::npos) << refusal;
}

TEST(LibraryRefusal, ALibraryThatFitsIsNotRefused) {
  EXPECT_EQ(refusal_of(library("WELL")), "no refusal");
  EXPECT_EQ(refusal_of(library("LOUD")), "no refusal");
}

TEST(LibraryRefusal, NoFile) {
  EXPECT_NE(refusal_of("/no/such/acme.so").find("There is no library /no/such/acme.so."),
            std::string::npos);
  EXPECT_NE(refusal_of("/tmp").find("There is no library /tmp."), std::string::npos);
}

TEST(LibraryRefusal, NoLibrary) {
  const std::string path = ::testing::TempDir() + "/text.so";
  std::ofstream(path) << "this is text\n";
  const std::string refusal = refusal_of(path);
  EXPECT_NE(refusal.find("cannot be loaded"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("-shared -fPIC"), std::string::npos) << refusal;
}

TEST(LibraryRefusal, NoEntry) {
  expect_refusal("WITHOUT_ENTRY", "exports no function gonogo_get_subject");
}
TEST(LibraryRefusal, NoInterfaceOfThisVersion) {
  expect_refusal("WITHOUT_INTERFACE", "has no C interface of version 1 or older");
}
TEST(LibraryRefusal, AnotherVersionThanAsked) {
  expect_refusal("OTHER_ABI", "build it with the header of version 1");
}
TEST(LibraryRefusal, AnOlderTable) {
  expect_refusal("OLDER_TABLE", "set it to sizeof(gonogo_subject_v1)");
}
TEST(LibraryRefusal, ANullFunction) {
  expect_refusal("NULL_FUNCTION", "all five are needed");
}
TEST(LibraryRefusal, ADescriptionThatIsNone) {
  expect_refusal("BAD_DESCRIPTION", "The reply needs \"subject\"");
}
TEST(LibraryRefusal, ACrashAtLoad) {
  expect_refusal("CRASH_AT_LOAD", "while it was loaded");
}

TEST(LibraryRefusal, AHangAtDescribe) {
  Limits limits = patient_limits();
  limits.start = std::chrono::milliseconds(500);
  const std::string refusal = refusal_of(library("HANG_AT_DESCRIBE"), limits);
  EXPECT_NE(refusal.find("within 500 ms"), std::string::npos) << refusal;
}

TEST(LibraryRefusal, ALibraryLoadsIntoThisProcessToo) {
  const auto subject = make_interface_subject(load_library(library("WELL")));
  subject->configure(profile_of("gsk988ta"));
  EXPECT_EQ(run(*subject, "kinds").records.size(), 8u);
  EXPECT_EQ(subject->info().max_in_flight, 1);
}

TEST(LibraryRefusal, InThisProcessTooTheSentenceIsTheSame) {
  EXPECT_THROW(load_library(library("WITHOUT_ENTRY")), SubjectUnusable);
  EXPECT_THROW(load_library(library("WITHOUT_INTERFACE")), SubjectUnusable);
  EXPECT_THROW(load_library("/no/such/acme.so"), SubjectUnusable);
}

}  // namespace
}  // namespace gonogo::oracle
