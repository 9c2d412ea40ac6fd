// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

namespace filmsticking::app {
namespace {

constexpr std::size_t kLineWidth = 100, kHelpColumn = 34;
constexpr int kMostFiles = 1 << 20;

/// CLI11's help, with long descriptions in several lines.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(kHelpColumn); }
  std::string make_option_desc(const CLI::Option* option) const override {
    std::istringstream words(option->get_description());
    std::string text;
    std::size_t width = 0;  // of the last line, with a space behind it
    for (std::string word; words >> word;) {
      if (width + word.size() > kLineWidth - kHelpColumn && width > 0) {
        text.back() = '\n';
        width = 0;
      }
      text += word + ' ';
      width += word.size() + 1;
    }
    text.pop_back();
    return text;
  }
};

bool is_flag(const CLI::Option& option) { return option.get_expected_max() == 0; }
bool is_repeatable(const CLI::Option& option) {
  return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

[[noreturn]] void fail_without_value(const CLI::Option& option) {
  throw UsageError(option.get_name() + " needs a value, " + option.get_type_name());
}

/// Reads all of `text`. Returns false if it is not such a number.
template <typename Number>
bool read_number(const std::string& text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end;
}

std::string shortest(double number) {
  char digits[32];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace

Arguments::Arguments() : app_(std::make_unique<CLI::App>()) {
  app_->set_help_flag();
  // A minimum that is never reached makes CLI11 take every word as it is; else "[a,b]" would become two.
  app_->add_option("FILE",
                   [this](const CLI::results_t& words) {
                     files_ = words;
                     return true;
                   })
      ->expected(kMostFiles)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

Arguments::~Arguments() = default;

CLI::Option* Arguments::add(const std::string& name, const std::string& value, const std::string& help,
                            const std::function<void(const std::vector<std::string>&)>& read) {
  const auto callback = [read](const CLI::results_t& texts) {
    read(texts);
    return true;
  };
  return app_->add_option(name, callback, help)->type_name(value)->group(group_);
}

void Arguments::flag(const std::string& name, const std::string& help, bool& variable, bool value) {
  app_->add_flag_callback(
          name, [&variable, value] { variable = value; }, help)
      ->group(group_);
}

void Arguments::action(const std::string& name, const std::string& help, const std::function<void()>& act) {
  app_->add_flag_callback(name, act, help)->group(group_);
}

void Arguments::only_flag(const std::string& name, const std::string& help, bool& given) {
  const auto stop = [&given] {
    given = true;
    throw CLI::Success();
  };
  app_->add_flag_callback(name, stop, help)->group(group_);
}

void Arguments::option(const std::string& name, const std::string& value, const std::string& help,
                       const std::function<void(const std::string&)>& read) {
  add(name, value, help, [read](const std::vector<std::string>& texts) { read(texts.front()); });
}

void Arguments::option(const std::string& name, const std::string& value, const std::string& help,
                       std::string& text) {
  option(name, value, help, [&text](const std::string& given) { text = given; });
}

void Arguments::optional(const std::string& name, const std::string& value, const std::string& help,
                         const std::string& fallback, const std::function<bool(const std::string&)>& is_value,
                         const std::function<void(const std::string&)>& read) {
  option(name, value, help, read);
  fallbacks_[name] = {fallback, is_value};
}

void Arguments::repeatable(const std::string& name, const std::string& value, const std::string& help,
                           std::vector<std::string>& texts) {
  add(name, value, help, [&texts](const std::vector<std::string>& given) {
    texts = given;
  })->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void Arguments::number(const std::string& name, const std::string& value, const std::string& help,
                       double& number, double least, double most) {
  option(name, value, help, [name, least, most, &number](const std::string& text) {
    if (read_number(text, number) && number >= least && number <= most && std::isfinite(number)) return;
    throw UsageError(name + " takes a number from " + shortest(least) +
                     (std::isfinite(most) ? " to " + shortest(most) : " on") + ", not '" + text + "'");
  });
}

void Arguments::positive(const std::string& name, const std::string& value, const std::string& help,
                         double& number, double most) {
  option(name, value, help, [name, most, &number](const std::string& text) {
    if (read_number(text, number) && number > 0 && number <= most && std::isfinite(number)) return;
    throw UsageError(name + " takes a number above zero" +
                     (std::isfinite(most) ? " and at most " + shortest(most) : "") + ", not '" + text + "'");
  });
}

/// CLI11 takes any word that follows as the value of "--name" and of "--name=", and repeated flags. This is
/// stricter. It also knows every option by its name and says what is wrong in a sentence.
void Arguments::check_words(int argc, const char* const* argv) const {
  std::set<const CLI::Option*> seen;
  const CLI::Option* waiting = nullptr;  // for its value
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], name = word.substr(0, word.find('='));
    if (word == "--") break;
    const CLI::Option* option = name[0] == '-' ? app_->get_option_no_throw(name) : nullptr;
    if (waiting && option) fail_without_value(*waiting);
    if (!waiting && option) {
      if (!seen.insert(option).second && !is_repeatable(*option))
        throw UsageError(option->get_name() + " is given twice");
      const bool has_value = name != word;
      if (has_value && is_flag(*option)) throw UsageError(option->get_name() + " takes no value");
      if (has_value && name.size() + 1 == word.size()) fail_without_value(*option);
      if (!has_value && !is_flag(*option)) waiting = option;
    } else {
      waiting = nullptr;
    }
  }
  if (waiting) fail_without_value(*waiting);
}

/// The words, those of options with a fallback as "--name=value".
std::vector<std::string> Arguments::with_fallbacks(int argc, const char* const* argv) const {
  std::vector<std::string> words(argv, argv + argc);
  for (std::size_t i = 1; i < words.size() && words[i] != "--"; ++i) {
    const auto known = fallbacks_.find(words[i]);
    if (known == fallbacks_.end()) continue;
    const bool given = i + 1 < words.size() && known->second.is_value(words[i + 1]);
    words[i] += "=" + (given ? words[i + 1] : known->second.value);
    if (given) words.erase(words.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return words;
}

bool Arguments::parse(int argc, const char* const* argv) {
  const std::vector<std::string> words = with_fallbacks(argc, argv);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  const int count = static_cast<int>(pointers.size());
  check_words(count, pointers.data());
  try {
    app_->parse(count, pointers.data());
  } catch (const CLI::Success&) {
    return false;
  } catch (const CLI::ExtrasError&) {
    throw UsageError("unrecognised option '" + app_->remaining().front() + "'");
  } catch (const CLI::Error& error) {
    throw UsageError(error.what());
  }
  return true;
}

bool Arguments::has(const std::string& name) const { return app_->count(name) > 0; }

std::string Arguments::help() const {
  const std::string groups = HelpFormatter().make_groups(app_.get(), CLI::AppFormatMode::Normal);
  return CLI::detail::find_and_replace(groups, "\n\n\n", "\n\n");
}

std::int64_t parse_count(const std::string& option, const std::string& text, std::int64_t least,
                         std::int64_t most) {
  std::int64_t number = 0;
  if (read_number(text, number) && number >= least && number <= most) return number;
  const std::string end = most == std::numeric_limits<int>::max() ? " on" : " to " + std::to_string(most);
  throw UsageError(option + " takes a whole number from " + std::to_string(least) + end + ", not '" + text +
                   "'");
}

}  // namespace filmsticking::app
