// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/page_parts.hpp"

#include <fmt/format.h>

#include "publish/report/escape.hpp"

namespace gonogo::oracle::report {

std::string page_head(std::string_view title, std::string_view style, const Asset* script) {
  std::string allowed;
  if (script != nullptr) {
    allowed = fmt::format("script-src 'sha256-{}'; ", base64_of_hex(script->sha256));
  }
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
      "'unsafe-inline'; {}img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>\n",
      allowed, title);
  out += kReportCss.text;
  out += kSiteCss.text;
  out += style;
  return out +
         "</style>\n</head>\n<body>\n<header id=\"head\">\n<p class=\"brand\">GoNoGo <span>master "
         "gauge for CNC canned cycles</span></p>\n";
}

std::string section(std::string_view id, std::string_view title, const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-title\"><h2 id=\"{0}-title\">{1}</h2>\n{2}"
      "</section>\n",
      id, title, content);
}

std::string table(std::string_view id, const std::string& head, const std::string& rows,
                  bool tall) {
  return fmt::format(
      "<div class=\"scroll{}\" tabindex=\"0\"><table id=\"{}\"><thead><tr>{}</tr></thead>\n"
      "<tbody>\n{}</tbody></table></div>\n",
      tall ? " tall" : "", id, head, rows);
}

}  // namespace gonogo::oracle::report
