// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module's doors: the page writes a request into request(size), calls answer() or catalog(), and
// reads what stands at text() for size() bytes.
#include <cstddef>
#include <string>

#include "playground/session.hpp"

namespace {

std::string question;
std::string reply;

}  // namespace

extern "C" {

[[clang::export_name("request")]] char* gonogo_request(std::size_t size) {
  question.resize(size);
  return question.data();
}
[[clang::export_name("answer")]] void gonogo_answer() { reply = gonogo::playground::answer(question); }
[[clang::export_name("catalog")]] void gonogo_catalog() { reply = gonogo::playground::catalog(); }
[[clang::export_name("text")]] const char* gonogo_text() { return reply.data(); }
[[clang::export_name("size")]] std::size_t gonogo_size() { return reply.size(); }

}  // extern "C"
