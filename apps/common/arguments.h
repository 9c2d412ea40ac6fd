// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines by CLI11. Only arguments.cpp includes it: it takes ten seconds to compile.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "usage_error.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace filmsticking::app {

/// A word that an option takes.
template <typename Meaning>
struct Choice {
  std::string word;
  Meaning meaning;
};

/// Describes the options of a program, then reads a command line. A name is "--name" or "-n,--name"; `value`
/// stands for the value in the help. Values are read in the order in which the options were added, whatever
/// their order on the command line. A variable keeps its value where its option is not given.
class Arguments {
 public:
  Arguments();
  ~Arguments();
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  /// Options that are added from here on stand under this heading in the help.
  void group(const std::string& heading) { group_ = heading; }

  /// Sets `variable` to `value`.
  void flag(const std::string& name, const std::string& help, bool& variable, bool value = true);

  /// A flag that does something.
  void action(const std::string& name, const std::string& help, const std::function<void()>& act);

  /// A flag that makes parse() skip all options added after it, such as --help.
  void only_flag(const std::string& name, const std::string& help, bool& given);

  /// `read` gets the text of the value, and may throw UsageError.
  void option(const std::string& name, const std::string& value, const std::string& help,
              const std::function<void(const std::string&)>& read);
  void option(const std::string& name, const std::string& value, const std::string& help, std::string& text);

  /// An option whose value may be left out: a word behind it is its value if `is_value`, which is asked
  /// before the word is read, says so; else its value is `fallback`.
  void optional(const std::string& name, const std::string& value, const std::string& help,
                const std::string& fallback, const std::function<bool(const std::string&)>& is_value,
                const std::function<void(const std::string&)>& read);

  /// An option that may be repeated, with one value each time.
  void repeatable(const std::string& name, const std::string& value, const std::string& help,
                  std::vector<std::string>& texts);

  /// A whole number from `least` to `most`.
  template <typename Integer>
  void count(const std::string& name, const std::string& value, const std::string& help, Integer& number,
             std::int64_t least, std::int64_t most = std::numeric_limits<int>::max());

  /// A finite number above zero, and at most `most`.
  void positive(const std::string& name, const std::string& value, const std::string& help, double& number,
                double most = std::numeric_limits<double>::infinity());

  /// A finite number from `least` to `most`.
  void number(const std::string& name, const std::string& value, const std::string& help, double& number,
              double least, double most);

  /// One of several words, each with its meaning.
  template <typename Meaning>
  void choice(const std::string& name, const std::string& value, const std::string& help, Meaning& meaning,
              const std::vector<Choice<Meaning>>& choices);

  /// Throws UsageError. Returns false if an only_flag() was given.
  bool parse(int argc, const char* const* argv);

  /// After parse(): the words that no option takes, in their order.
  const std::vector<std::string>& files() const { return files_; }

  /// After parse(): whether the option was given; by its long name, with dashes.
  bool has(const std::string& name) const;

  /// The options under their headings, in lines of at most 100 characters.
  std::string help() const;

 private:
  CLI::Option* add(const std::string& name, const std::string& value, const std::string& help,
                   const std::function<void(const std::vector<std::string>&)>& read);
  void check_words(int argc, const char* const* argv) const;
  std::vector<std::string> with_fallbacks(int argc, const char* const* argv) const;

  struct Fallback {
    std::string value;
    std::function<bool(const std::string&)> is_value;
  };

  std::unique_ptr<CLI::App> app_;
  std::string group_ = "Options";
  std::vector<std::string> files_;
  std::map<std::string, Fallback> fallbacks_;  // by the option's name
};

/// A whole number from `least` to `most`. Throws UsageError.
std::int64_t parse_count(const std::string& option, const std::string& text, std::int64_t least,
                         std::int64_t most = std::numeric_limits<int>::max());

template <typename Integer>
void Arguments::count(const std::string& name, const std::string& value, const std::string& help,
                      Integer& number, std::int64_t least, std::int64_t most) {
  option(name, value, help, [name, least, most, &number](const std::string& text) {
    number = static_cast<Integer>(parse_count(name, text, least, most));
  });
}

/// Throws UsageError for a word that is none of them.
template <typename Meaning>
Meaning parse_choice(const std::string& option, const std::string& text,
                     const std::vector<Choice<Meaning>>& choices) {
  std::string words;
  for (const Choice<Meaning>& choice : choices) {
    if (text == choice.word) return choice.meaning;
    words += (words.empty() ? "" : ", ") + choice.word;
  }
  throw UsageError(option + " takes one of " + words + ", not '" + text + "'");
}

template <typename Meaning>
void Arguments::choice(const std::string& name, const std::string& value, const std::string& help,
                       Meaning& meaning, const std::vector<Choice<Meaning>>& choices) {
  option(name, value, help,
         [name, choices, &meaning](const std::string& text) { meaning = parse_choice(name, text, choices); });
}

}  // namespace filmsticking::app
