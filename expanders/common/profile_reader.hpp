// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "expanders/common/machine_profile.hpp"

namespace gonogo::expanders {

/// A reading with two outcomes, both implemented: `option` is set by the other one.
template <typename Configuration>
struct Choice {
  const char* key;
  const char* standard;
  const char* other;
  bool Configuration::*option;
};

using ConfigurationResult = ProfileResult;

/// Reads {"dialect", "profile"} as `create` gets it; a maker's reader gives the keys. Every
/// function returns false, and has then put a message, when a value is not implemented.
class ProfileReader {
 public:
  using Json = nlohmann::json;

  /// Where the keys go that every maker has.
  struct Common {
    bool& inch;
    bool& block_skip;
  };

  ProfileReader(std::string_view dialect, std::string& message, const Common& common)
      : dialect_(dialect), message_(message), common_(common) {}
  ProfileReader(const ProfileReader&) = delete;
  ProfileReader& operator=(const ProfileReader&) = delete;
  virtual ~ProfileReader() = default;

  ConfigurationResult read(std::string_view text);

 protected:
  /// The whole profile, an object: `entry` for each key.
  virtual bool profile(const Json& json);
  /// A key that not every maker has.
  virtual bool setting(const std::string& key, const Json& value) = 0;
  /// A key of the state at power-on.
  virtual bool initial(const std::string& key, const Json& value) = 0;
  virtual bool reading(const std::string& key, const Json& json) = 0;

  /// A key of the profile: one that every maker has, or `setting`.
  bool entry(const std::string& key, const Json& value);
  /// A setting of another maker: here it can only be the default.
  bool foreign(const std::string& key, const Json& value);
  bool refuse(const std::string& key, const Json& value);
  bool decimal(const std::string& key, const Json& json, Fixed& value);
  /// From 0 to `most`.
  bool not_negative(const std::string& key, const Json& json, Fixed& value, Fixed most = kLargest);
  bool axis(const std::string& key, const Json& json, Point& point);
  /// An object of axes.
  bool point(const std::string& key, const Json& json, Point& point);
  /// A G code as "G18", "18" or 18, from lowest to highest.
  bool code(const std::string& key, const Json& json, int lowest, int highest, int& value);
  bool boolean(const std::string& key, const Json& json, bool& value);
  bool word(const std::string& key, const Json& json, std::string_view no, std::string_view yes,
            bool& value);
  /// Whether a reading is left open: the standard outcome is admissible, and is the one taken.
  static bool is_any(const Json& json);
  static std::string text_of(const Json& json);

  /// Reads a reading that is one of `choices`; nothing: it is none of them.
  template <typename Configuration, std::size_t kCount>
  std::optional<bool> choice(const Choice<Configuration> (&choices)[kCount], const std::string& key,
                             const Json& json, Configuration& configuration) {
    for (const Choice<Configuration>& one : choices) {
      if (key != one.key) continue;
      return is_any(json) || word(key, json, one.standard, one.other, configuration.*one.option);
    }
    return std::nullopt;
  }

 private:
  using Part = bool (ProfileReader::*)(const std::string& key, const Json& value);
  bool document(const Json& json);
  bool dialect(const Json& value);
  /// `part` for each key of an object.
  bool each(const std::string& name, const Json& json, Part part);

  std::string_view dialect_;
  std::string& message_;
  Common common_;
};

}  // namespace gonogo::expanders
