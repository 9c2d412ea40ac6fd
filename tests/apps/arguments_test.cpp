// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/arguments.h"

#include <gtest/gtest.h>

namespace filmsticking::app {
namespace {

/// A program with an option of each kind.
struct Program {
  bool help = false, flag = false;
  std::string text = "default";
  std::vector<std::string> labels;
  int count = 5;
  double length = 1;
  char letter = 'x';
  std::vector<std::string> files;
  Arguments arguments;

  Program() {
    arguments.only_flag("--help", "print this text", help);
    arguments.flag("--flag", "a flag", flag);
    arguments.group("More");
    arguments.option("-t,--text", "TEXT", "a text", text);
    arguments.repeatable("--label", "LABEL", "a label", labels);
    arguments.count("--count", "N", "how many", count, 1, 99);
    arguments.positive("--length", "L", "how long", length);
    arguments.choice("--letter", "a|b", "a letter", letter, {{"a", 'A'}, {"b", 'B'}});
  }

  bool parse(std::vector<const char*> words) {
    words.insert(words.begin(), "program");
    const bool all = arguments.parse(static_cast<int>(words.size()), words.data());
    files = arguments.files();
    return all;
  }

  /// What a wrong command line is refused with.
  std::string complaint(const std::vector<const char*>& words) {
    try {
      parse(words);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "none";
  }
};

using Words = std::vector<std::string>;

TEST(Arguments, WhatIsNotGivenKeepsItsValue) {
  Program program;
  EXPECT_TRUE(program.parse({}));
  EXPECT_EQ(program.text, "default");
  EXPECT_EQ(program.count, 5);
  EXPECT_EQ(program.files, Words());
  EXPECT_FALSE(program.arguments.has("--text"));
}

TEST(Arguments, FilesAndOptionsComeInAnyOrder) {
  Program program;
  EXPECT_TRUE(program.parse({"a", "--count", "7", "b", "--flag", "c", "-t", "word", "--letter=b"}));
  EXPECT_EQ(program.files, (Words{"a", "b", "c"}));
  EXPECT_EQ(program.count, 7);
  EXPECT_TRUE(program.flag);
  EXPECT_EQ(program.text, "word");
  EXPECT_EQ(program.letter, 'B');
  EXPECT_TRUE(program.arguments.has("--text"));
}

TEST(Arguments, AValueMayBeginWithADashAndHoldCommas) {
  Program program;
  EXPECT_TRUE(program.parse({"--text", "-1,2,-3", "-"}));
  EXPECT_EQ(program.text, "-1,2,-3");
  EXPECT_EQ(program.files, Words{"-"});
  EXPECT_TRUE(Program().parse({"--text=--flag"}));
}

TEST(Arguments, AValueMayBeEmpty) {
  Program program;
  EXPECT_TRUE(program.parse({"--text", "", ""}));
  EXPECT_EQ(program.text, "");
  EXPECT_EQ(program.files, Words{""});
}

TEST(Arguments, ARepeatableOptionTakesOneWordEachTime) {
  Program program;
  EXPECT_TRUE(program.parse({"--label", "one", "file", "--label", "[a,b]", "--label", "c,d"}));
  EXPECT_EQ(program.labels, (Words{"one", "[a,b]", "c,d"}));
  EXPECT_EQ(program.files, Words{"file"});
}

TEST(Arguments, BracketsInTheNameOfAFileAreNoList) {
  Program program;
  EXPECT_TRUE(program.parse({"[a,b]", "{}", "%%"}));
  EXPECT_EQ(program.files, (Words{"[a,b]", "{}", "%%"}));
}

TEST(Arguments, AfterTwoDashesAllAreFiles) {
  Program program;
  EXPECT_TRUE(program.parse({"--flag", "--", "--count", "-t", "--flag"}));
  EXPECT_EQ(program.files, (Words{"--count", "-t", "--flag"}));
  EXPECT_EQ(program.count, 5);
}

TEST(Arguments, HelpIsGivenWhateverElseIsWrong) {
  Program program;
  EXPECT_FALSE(program.parse({"--count", "many", "--nonsense", "--help"}));
  EXPECT_TRUE(program.help);
}

TEST(Arguments, RefusesInASentence) {
  for (const auto& [sentence, words] : std::vector<std::pair<std::string, std::vector<const char*>>>{
           {"unrecognised option '--nonsense'", {"file", "--nonsense", "5"}},
           {"unrecognised option '--fla'", {"--fla"}},
           {"unrecognised option '-x'", {"-x"}},
           {"--text needs a value, TEXT", {"--text"}},
           {"--text needs a value, TEXT", {"--text", "--flag"}},
           {"--text needs a value, TEXT", {"--text=", "word"}},
           {"--text needs a value, TEXT", {"-t", "--", "word"}},
           {"--text is given twice", {"--text", "a", "-t", "b"}},
           {"--flag is given twice", {"--flag", "--flag"}},
           {"--flag takes no value", {"--flag=true"}},
           {"--count takes a whole number from 1 to 99, not '0'", {"--count", "0"}},
           {"--count takes a whole number from 1 to 99, not '100'", {"--count", "100"}},
           {"--count takes a whole number from 1 to 99, not '5x'", {"--count", "5x"}},
           {"--count takes a whole number from 1 to 99, not '0x10'", {"--count", "0x10"}},
           {"--count takes a whole number from 1 to 99, not ''", {"--count", ""}},
           {"--length takes a number above zero, not 'inf'", {"--length", "inf"}},
           {"--length takes a number above zero, not '-1'", {"--length", "-1"}},
           {"--letter takes one of a, b, not '0'", {"--letter", "0"}},
       })
    EXPECT_EQ(Program().complaint(words), sentence);
}

TEST(Arguments, NumbersAreDecimal) {
  Program program;
  EXPECT_TRUE(program.parse({"--count", "010", "--length", "1e-3"}));
  EXPECT_EQ(program.count, 10);
  EXPECT_EQ(program.length, 1e-3);
}

TEST(Arguments, HelpHasEveryOptionUnderItsHeading) {
  const std::string help = Program().arguments.help();
  const std::size_t heading = help.find("\nMore:\n");
  ASSERT_NE(heading, std::string::npos) << help;
  for (const char* name : {"--help", "--flag"}) EXPECT_LT(help.find(name), heading) << name;
  for (const char* name : {"-t,--text TEXT", "--label LABEL", "--count N", "--length L", "--letter a|b"}) {
    EXPECT_NE(help.find(name), std::string::npos) << name;
    EXPECT_GT(help.find(name), heading) << name;
  }
}

}  // namespace
}  // namespace filmsticking::app
