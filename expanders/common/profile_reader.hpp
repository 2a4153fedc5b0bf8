// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"

namespace gonogo::expanders {

/// A reading with two outcomes, both implemented: `option` is set by the other one.
template <typename Configuration>
struct Choice {
  const char* key;
  const char* standard;
  const char* other;
  bool Configuration::*option;
};

enum class ConfigurationResult { kRead, kUnsupported, kMalformed };

/// Reads {"dialect", "profile"} as `create` gets it; a maker's reader gives the keys. Every
/// function returns false, and has then put a message, when a value is not implemented.
class ProfileReader {
 public:
  using Json = nlohmann::json;

  ProfileReader(std::string_view dialect, std::string& message)
      : dialect_(dialect), message_(message) {}
  ProfileReader(const ProfileReader&) = delete;
  ProfileReader& operator=(const ProfileReader&) = delete;
  virtual ~ProfileReader() = default;

  ConfigurationResult read(std::string_view text);

 protected:
  /// The whole profile, an object.
  virtual bool profile(const Json& json) = 0;
  virtual bool reading(const std::string& key, const Json& json) = 0;

  bool refuse(const std::string& key, const Json& value);
  bool dialect(const Json& value);
  bool readings(const Json& json);
  bool decimal(const std::string& key, const Json& json, Fixed& value);
  bool axis(const std::string& key, const Json& json, Point& point);
  /// An object of axes.
  bool point(const std::string& key, const Json& json, Point& point);
  /// A G code as "G18", "18" or 18, from lowest to highest.
  bool code(const std::string& key, const Json& json, int lowest, int highest, int& value);
  bool boolean(const std::string& key, const Json& json, bool& value);
  bool word(const std::string& key, const Json& json, std::string_view no, std::string_view yes,
            bool& value);
  static std::string text_of(const Json& json);

 private:
  bool document(const Json& json);

  std::string_view dialect_;
  std::string& message_;
};

}  // namespace gonogo::expanders
