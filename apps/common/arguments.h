// SPDX-License-Identifier: GPL-3.0-or-later
// Command lines by Boost.Program_options: long options, and words without dashes as files.
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <string>
#include <vector>

#include "usage_error.h"

namespace filmsticking::app {

/// The options and files of a command line.
class Arguments {
 public:
  /// Throws UsageError.
  Arguments(int argc, const char* const* argv, const boost::program_options::options_description& options);

  const std::vector<std::string>& files() const { return files_; }
  bool has(const char* option) const { return given_.count(option) > 0; }

  /// The option's text; empty where it is not given.
  std::string text(const char* option) const {
    return has(option) ? given_[option].as<std::string>() : std::string();
  }

  /// Calls use(name, text) if the option is there: its name stands once where it is read.
  template <typename Use>
  void with(const char* option, const Use& use) const {
    if (has(option)) use(std::string(option), text(option));
  }

 private:
  boost::program_options::variables_map given_;
  std::vector<std::string> files_;
};

/// A whole number from `least` on. Throws UsageError.
int parse_count(const std::string& option, const std::string& text, int least);

/// A number above zero. Throws UsageError.
double parse_positive(const std::string& option, const std::string& text);

/// One of several words, each with its meaning.
template <typename Meaning>
struct Choice {
  const char* word;
  Meaning meaning;
};

/// Throws UsageError for a word that is none of them.
template <typename Meaning>
Meaning parse_choice(const std::string& option, const std::string& text,
                     const std::vector<Choice<Meaning>>& choices) {
  std::string words;
  for (const Choice<Meaning>& choice : choices) {
    if (text == choice.word) return choice.meaning;
    words += (words.empty() ? "" : ", ") + std::string(choice.word);
  }
  throw UsageError("--" + option + " takes one of " + words + ", not '" + text + "'");
}

}  // namespace filmsticking::app
