// Ensembles of other programs: every form that is understood gives the same matrix, and every complaint names its
// place.
#include "analysis/files/csv.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <brouwer/error.hpp>
#include <filesystem>
#include <fstream>
#include <random>

namespace brouwer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A file in the test's own folder, removed with it.
class Csv : public testing::Test {
 protected:
  Csv() {
    auto const* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              fmt::format("brouwer-csv-{}-{}", std::string(test->name()).substr(0, 60), std::random_device{}());
    std::filesystem::create_directories(folder_);
  }
  ~Csv() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(std::string const& text) const {
    std::ofstream(folder_ / "errors.csv", std::ios::binary) << text;
    return folder_ / "errors.csv";
  }

  Ensemble read_one(std::string const& text) const {
    auto ensembles = read_csv(write(text));
    EXPECT_EQ(ensembles.size(), 1u);
    return ensembles.at(0);
  }

  /// What is said of this text, without the folder.
  std::string complaint(std::string const& text) const { return complaint_of(write(text)); }

  std::string complaint_of(std::filesystem::path const& file) const {
    try {
      read_csv(file);
    } catch (InputError const& error) {
      std::string const message = error.what(), place = folder_.string() + "/";
      return message.starts_with(place) ? message.substr(place.size()) : message;
    }
    return "";
  }

  std::filesystem::path folder_;
};

std::string const long_form = "time,member,error\n1,0,1e-17\n2,0,-2e-17\n1,1,3e-17\n2,1,4e-17\n1,2,5e-17\n2,2,0\n";

void expect_the_ensemble(Ensemble const& e) {
  EXPECT_THAT(e.times, ElementsAre(1, 2));
  ErrorMatrix expected(3, 2);
  expected << 1e-17, -2e-17, 3e-17, 4e-17, 5e-17, 0;
  EXPECT_EQ(e.errors, expected);
}

struct Form {
  char const* name;
  std::string text;
};
void PrintTo(Form const& form, std::ostream* out) { *out << form.name; }

std::string replaced(std::string text, std::string const& what, std::string const& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size()) text.replace(at, what.size(), by);
  return text;
}

class Understood : public Csv, public testing::WithParamInterface<Form> {};
TEST_P(Understood, IsTheSameEnsemble) { expect_the_ensemble(read_one(GetParam().text)); }

INSTANTIATE_TEST_SUITE_P(
    Forms, Understood,
    testing::Values(
        Form{"long", long_form}, Form{"semicolons", replaced(long_form, ",", ";")},
        Form{"tabs", replaced(long_form, ",", "\t")}, Form{"blanks", replaced(long_form, ",", "   ")},
        Form{"blanks_after_commas", replaced(long_form, ",", " , ")}, Form{"crlf", replaced(long_form, "\n", "\r\n")},
        Form{"byte_order_mark", "\xEF\xBB\xBF" + long_form},
        Form{"no_last_line_end", long_form.substr(0, long_form.size() - 1)},
        Form{"comments", "# made by hand\n\n" + replaced(long_form, "2,0,", "  # in between\n\n2,0,")},
        Form{"quoted", replaced(long_form, "time,member,error", "\"time\",\"member\",\"error\"")},
        Form{"capitals", replaced(long_form, "time,member,error", "Time,Member,ERROR")},
        Form{"plus_signs", replaced(long_form, "4e-17", "+4e-17")},
        Form{"time_zero", long_form + "0,0,0\n0,1,0.0\n0,2,-0\n"},
        Form{"shuffled", "error,time,member\n4e-17,2,1\n1e-17,1,0\n0,2,2\n5e-17,1,2\n-2e-17,2,0\n3e-17,1,1\n"},
        Form{"other_columns",
             "member,note,time,h,error\n"
             "0,\"a, b\",1,x,1e-17\n0,,2,x,-2e-17\n1,,1,x,3e-17\n1,,2,x,4e-17\n2,,1,x,5e-17\n2,,2,x,0\n"},
        Form{"wide", "1,1e-17,3e-17,5e-17\n2,-2e-17,4e-17,0\n"},
        Form{"wide_with_header", "time,a,b,c\n1,1e-17,3e-17,5e-17\n2,-2e-17,4e-17,0\n"},
        Form{"wide_with_numbers_as_header", "time,0,1,2\n1,1e-17,3e-17,5e-17\n2,-2e-17,4e-17,0\n"},
        Form{"wide_with_members_as_header", "t member1 member2 member3\n1 1e-17 3e-17 5e-17\n2 -2e-17 4e-17 0\n"},
        Form{"wide_and_backwards", "2;-2e-17;4e-17;0\n1;1e-17;3e-17;5e-17\n0;0;0;0\n"}),
    [](auto const& test) { return test.param.name; });

TEST_F(Csv, MembersAreInOrderOfTheirNumbersAndThenOfTheirNames) {
  auto const e = read_one("time,member,error\n1,10,10\n2,10,0\n1,b,12\n2,b,0\n1,9,9\n2,9,0\n1,a,11\n2,a,0\n");
  EXPECT_EQ(e.errors(0, 0), 9);
  EXPECT_EQ(e.errors(1, 0), 10);
  EXPECT_EQ(e.errors(2, 0), 11);
  EXPECT_EQ(e.errors(3, 0), 12);
}

TEST_F(Csv, LabelsTellEnsemblesApart) {
  std::string text = "time,member,quantity,method,error\n";
  for (auto const* quantity : {"energy", "casimir"})
    for (auto const* method : {"a", "b"})
      for (int member = 0; member < 2; ++member)
        for (int time = 1; time < 3; ++time)
          text += fmt::format("{},{},{},{},{}\n", time, member, quantity, method, time);
  auto const ensembles = read_csv(write(text));
  ASSERT_EQ(ensembles.size(), 4u);
  EXPECT_EQ(ensembles[1].quantity, "energy");
  EXPECT_EQ(ensembles[1].family, "energy");
  EXPECT_EQ(ensembles[1].cell.method, "b");
  EXPECT_EQ(ensembles[2].quantity, "casimir");
  EXPECT_EQ(ensembles[2].cell.method, "a");
}

TEST_F(Csv, ATimeCountedInStepsIsPerStep) {
  EXPECT_EQ(read_one(long_form).time_unit, "time unit");
  EXPECT_EQ(read_one(replaced(long_form, "time", "steps")).time_unit, "step");
  EXPECT_EQ(read_one("step,a,b\n1,1,2\n2,2,3\n").time_unit, "step");
}

TEST_F(Csv, ReadsLinesLongerThanABlock) {
  std::string one = "1", two = "2";
  constexpr int members = 200'000;
  for (int i = 0; i < members; ++i) (one += ',') += std::to_string(i), two += ",1e-17";
  auto const e = read_one(one + "\n" + two + "\n");
  ASSERT_EQ(e.errors.rows(), members);
  EXPECT_EQ(e.errors(members - 1, 0), members - 1);
  EXPECT_EQ(e.errors(members - 1, 1), 1e-17);
}

struct Flaw {
  char const* name;
  std::string text;
  char const* complaint;
};
void PrintTo(Flaw const& flaw, std::ostream* out) { *out << flaw.name; }

class Refused : public Csv, public testing::WithParamInterface<Flaw> {};
TEST_P(Refused, WithASentenceThatNamesThePlace) {
  EXPECT_THAT(complaint(GetParam().text), HasSubstr(GetParam().complaint));
}

INSTANTIATE_TEST_SUITE_P(
    Flaws, Refused,
    testing::Values(
        Flaw{"empty", "", "errors.csv: the file is empty"},
        Flaw{"comments_only", "# hello\n\n", "errors.csv: the file is empty"},
        Flaw{"header_only", "time,member,error\n", "no error at a time above 0"},
        Flaw{"wide_header_only", "time,a,b\n", "no sample time"},
        Flaw{"text", long_form + "3,0,abc\n", "errors.csv:8: column 3 (error): expected a number, found 'abc'"},
        Flaw{"text_after_number", long_form + "3,0,1e-17x\n", "errors.csv:8: column 3 (error): expected a number"},
        Flaw{"no_number", long_form + "3,0,\n", "errors.csv:8: column 3 (error): expected a number, found ''"},
        Flaw{"decimal_comma", "time;member;error\n1;0;1,5e-17\n",
             "errors.csv:2: column 3 (error): expected a number, found '1,5e-17'"},
        Flaw{"nan", long_form + "3,0,nan\n", "errors.csv:8: column 3 (error): expected a finite number"},
        Flaw{"infinity", long_form + "3,0,-inf\n", "errors.csv:8: column 3 (error): expected a finite number"},
        Flaw{"out_of_range", long_form + "3,0,1e999\n", "errors.csv:8: column 3 (error): expected a finite number"},
        Flaw{"nan_time", long_form + "nan,0,1\n", "errors.csv:8: column 1 (time): expected a finite number"},
        Flaw{"negative_time", long_form + "-3,0,1\n",
             "errors.csv:8: column 1 (time): expected a time from 0 on, found '-3'"},
        Flaw{"no_member", long_form + "3,,1\n", "errors.csv:8: the member is missing"},
        Flaw{"too_few_fields", long_form + "3,0\n", "errors.csv:8: expected 3 columns as in the first line, found 2"},
        Flaw{"too_many_fields", long_form + "3,0,1,2\n",
             "errors.csv:8: expected 3 columns as in the first line, found 4"},
        Flaw{"hole", long_form + "3,0,1\n3,2,1\n", "errors.csv:5: member '1' has no error at time 3"},
        Flaw{"duplicate", long_form + "2,1,7\n", "errors.csv:8: member '1' has an error at time 2 in line 5 already"},
        Flaw{"duplicate_and_hole", replaced(long_form, "2,2,0", "1,2,7"),
             "errors.csv:7: member '2' has an error at time 1 in line 6 already"},
        Flaw{"one_member", "time,member,error\n1,0,1\n2,0,2\n", "one member only"},
        Flaw{"one_time", "time,member,error\n1,0,1\n1,1,2\n", "one sample time only"},
        Flaw{"error_at_the_start", long_form + "0,0,1e-17\n", "errors.csv:8: the error at time 0 is 1e-17"},
        Flaw{"misspelt_column", "time,member,eror\n1,0,1\n", "errors.csv:1: expected a column 'error', found 'eror'"},
        Flaw{"two_misspelt_columns", "time,membr,eror\n1,0,1\n",
             "errors.csv:1: expected a column 'member', found 'membr'"},
        Flaw{"missing_column", "member,error\n0,1\n",
             "errors.csv:1: expected a column 'time', found only member, error"},
        Flaw{"double_column", "time,member,error,error\n1,0,1,1\n", "errors.csv:1: there are two columns 'error'"},
        Flaw{"unknown_columns", "a,b,c\n1,0,1\n",
             "errors.csv:1: expected 'time' as name of the first column, found 'a'"},
        Flaw{"one_column", "hello\nworld\n", "errors.csv:1: expected columns time, member, error"},
        Flaw{"long_form_without_header", "1,0,1\n2,0,1\n1,1,1\n2,1,1\n",
             "errors.csv:3: time 1 was given in line 1 already"},
        Flaw{"wide_text", "1,1,2\n2,1,x\n", "errors.csv:2: column 3: expected a number, found 'x'"},
        Flaw{"wide_hole", "1,1,2\n2,1\n", "errors.csv:2: expected 3 columns as in the first line, found 2"},
        Flaw{"wide_error_at_the_start", "0,1,2\n1,1,2\n", "errors.csv:1: the error at time 0 is 1"},
        Flaw{"wide_one_member", "1,1\n2,1\n", "one member only"},
        Flaw{"wide_one_time", "1,1,2\n", "one sample time only"},
        Flaw{"zero_bytes", std::string("time,member,error\n1,\0,1\n", 24), "errors.csv:2: a zero byte"},
        Flaw{"control_characters", "time,member,error\n1,0,\x1b[31m\n", "found '?[31m'"}),
    [](auto const& test) { return test.param.name; });

TEST_F(Csv, RefusesWhatIsNoFile) {
  EXPECT_THAT(complaint_of(folder_ / "nowhere.csv"), testing::Eq("nowhere.csv: there is no such file"));
  EXPECT_THAT(complaint_of(folder_), HasSubstr("this is a folder"));
}

TEST_F(Csv, StrayLinesDoNotAskForAHugeMatrix) {
  std::string text = "time,member,error\n";  // a matrix of 10¹⁰ entries, one of them in each line
  for (int i = 1; i <= 100'000; ++i) text += fmt::format("{},{},1\n", i, i);
  EXPECT_THAT(complaint(text), HasSubstr("has no error at time"));
}

TEST_F(Csv, NoBytesCrashIt) {
  std::mt19937 random(1);
  std::string const alphabet = "019.,;\t \n\r-+eE#\"nantimemembererror\xEF\xBB\xBF\x01";
  for (int k = 0; k < 400; ++k) {
    std::string text = k % 2 ? long_form : "";
    for (unsigned i = 0; i < 60; ++i) {
      std::string const junk(1, alphabet[random() % alphabet.size()]);
      if (k % 2 && i < 4) text.replace(random() % text.size(), 1, junk);
      if (k % 2 == 0) text += junk;
    }
    complaint(text);  // an InputError or none; anything else ends the test
  }
}

TEST_F(Csv, KeepsTheNamesOfMembers) {
  EXPECT_THAT(read_one("time,member,error\n1,b,1\n2,b,2\n1,10,3\n2,10,4\n1,9,5\n2,9,6\n").names,
              ElementsAre("9", "10", "b"));
  EXPECT_THAT(read_one("time,mercury,venus\n1,1,2\n2,3,4\n").names, ElementsAre("mercury", "venus"));
  EXPECT_TRUE(read_one("1,1,2\n2,3,4\n").names.empty());
}

}  // namespace
}  // namespace brouwer
