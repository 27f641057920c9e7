// Clouds in phase space: what is shown, in which axes, and that the files are drawn whatever names say.
#include "analysis/figures/cloud.hpp"

#include <gmock/gmock.h>

#include <brouwer/error.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "analysis/figures/cloud_film.hpp"

namespace brouwer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Members on a circle of radius `growth`^time, turning.
Orbits rotation(std::string const& method, std::size_t members, std::size_t samples, double growth = 1) {
  Orbits cell;
  cell.cell = {"oscillator", method, "double", "-", "-", false, 0.1, static_cast<std::int64_t>(samples)};
  cell.names = {"q", "p", "phase"};
  cell.members = members;
  for (std::size_t j = 0; j <= samples; ++j) cell.times.push_back(static_cast<double>(j));
  for (std::size_t i = 0; i < members; ++i)
    for (double const t : cell.times) {
      double const angle = 6.28 * static_cast<double>(i) / static_cast<double>(members) + 0.1 * t;
      for (double const x : {std::cos(angle), std::sin(angle), angle}) cell.states.push_back(std::pow(growth, t) * x);
    }
  return cell;
}

TEST(CloudFilm, HasAFrameASampleAndItsTimes) {
  auto const film = film_of({rotation("a", 8, 20)}, {});
  EXPECT_EQ(film.frames(), 21u);
  EXPECT_EQ(film.cells[0].times.front(), "0.0");
  EXPECT_EQ(film.cells[0].times.back(), "2.0");
  EXPECT_EQ(film.x, "q");
  EXPECT_EQ(film.y, "p");
}

TEST(CloudFilm, IsThinnedEvenlyAndKeepsTheLastFrame) {
  for (std::size_t const samples : {119U, 120U, 121U, 237U, 238U, 239U, 1000U, 12'345U}) {
    auto const moments = film_of({rotation("a", 2, samples)}, {}).moments;
    EXPECT_LE(moments.size(), most_frames) << samples;
    EXPECT_GE(moments.size(), most_frames / 2) << samples;
    EXPECT_EQ(moments.back(), samples);
    for (std::size_t i = 2; i + 1 < moments.size(); ++i)
      ASSERT_EQ(moments[i] - moments[i - 1], moments[1] - moments[0]) << samples;
  }
}

TEST(CloudFilm, ShowsACellOfFewerSamplesAtTheSameShareOfItsTime) {
  auto const film = film_of({rotation("a", 3, 20), rotation("b", 3, 10)}, {});
  EXPECT_EQ(film.cells[1].times.size(), film.cells[0].times.size());
  EXPECT_EQ(film.cells[1].times[10], "0.5");
  EXPECT_EQ(film.cells[1].times.back(), "1.0");
}

TEST(CloudFilm, HasOneScaleAndItsAxesHoldTheClouds) {
  auto const film = film_of({rotation("a", 64, 20)}, {});
  EXPECT_NEAR(film.x_range.low, -1.12, 0.02);
  EXPECT_NEAR(film.y_range.high, 1.12, 0.02);
  for (auto const unseen : film.cells[0].unseen) EXPECT_EQ(unseen, 0u);
}

TEST(CloudFilm, DoesNotFollowACloudThatRunsAway) {
  auto const film = film_of({rotation("tame", 64, 20), rotation("wild", 64, 20, 2)}, {});
  EXPECT_LT(film.x_range.high, 2.5);
  EXPECT_EQ(film.cells[0].unseen.back(), 0u);
  EXPECT_EQ(film.cells[1].unseen.front(), 0u);
  EXPECT_EQ(film.cells[1].unseen.back(), 64u);
}

/// Member 2 leaves the circle, ever faster.
Orbits with_one_gone(Orbits cell) {
  for (std::size_t j = 1; j < cell.times.size(); ++j)
    for (std::size_t c = 0; c < 3; ++c)
      cell.states[(2 * cell.times.size() + j) * 3 + c] = std::pow(1e15, static_cast<double>(j));
  return cell;
}

TEST(CloudFilm, DoesNotFollowAMemberThatLeavesItsCloud) {
  auto const a = with_one_gone(rotation("a", 8, 20)), b = with_one_gone(rotation("b", 8, 20));
  for (auto const& film : {film_of({a}, {}), film_of({a, b}, {}), film_of({with_one_gone(rotation("c", 3, 20))}, {})}) {
    EXPECT_LT(film.x_range.high, 2);
    EXPECT_GT(film.x_range.low, -1.5);
    for (auto const& cell : film.cells) {
      EXPECT_EQ(cell.unseen.front(), 0u);
      EXPECT_EQ(cell.unseen.back(), 1u);
      EXPECT_EQ(cell.ended.back(), 0u);
    }
  }
}

TEST(CloudFilm, JudgesByThoseThatCameThrough) {
  auto cell = rotation("a", 8, 20);
  for (std::size_t i = 3; i < 8; ++i)  // five of eight run away, and fail
    for (std::size_t j = 10; j < 21; ++j)
      for (std::size_t c = 0; c < 3; ++c) cell.states[(i * 21 + j) * 3 + c] = j < 20 ? 1e200 : std::nan("");
  auto const film = film_of({cell}, {});
  EXPECT_LT(film.x_range.high, 2);
  EXPECT_EQ(film.cells[0].unseen[19], 5u);
  EXPECT_EQ(film.cells[0].unseen.back(), 0u);
  EXPECT_EQ(film.cells[0].ended.back(), 5u);
}

TEST(CloudFilm, ShowsTheStartOfEveryMember) {
  auto cell = rotation("a", 8, 20);
  for (std::size_t j = 0; j < 21; ++j) cell.states[(2 * 21 + j) * 3] += 40;
  auto const film = film_of({cell}, {});
  EXPECT_GT(film.x_range.high, 40);
  EXPECT_EQ(film.cells[0].unseen.front(), 0u);
}

TEST(CloudFilm, CountsMembersThatFailedAsEnded) {
  auto cell = rotation("a", 8, 4);
  for (std::size_t j = 3; j < 5; ++j) cell.states[(2 * 5 + j) * 3] = std::nan("");
  auto const film = film_of({cell}, {});
  EXPECT_THAT(film.cells[0].ended, ElementsAre(0, 0, 0, 1, 1));
  EXPECT_THAT(film.cells[0].unseen, ElementsAre(0, 0, 0, 0, 0));
  EXPECT_THAT(film.data, HasSubstr("NaN "));
}

TEST(CloudFilm, OfManyMembersShowsSomeAndSaysSo) {
  auto const film = film_of({rotation("a", 1500, 1)}, {});
  EXPECT_EQ(film.cells[0].points, most_points);
  EXPECT_THAT(film.subtitle, HasSubstr("600 of 1500 members; colour: q at the start"));
}

TEST(CloudFilm, OfManyCellsShowsTheFirstAndSaysSo) {
  std::vector<Orbits> cells;
  for (int i = 0; i < 58; ++i) cells.push_back(rotation("m" + std::to_string(i), 2, 1));
  auto const film = film_of(cells, {});
  ASSERT_EQ(film.cells.size(), most_cells);
  EXPECT_EQ(film.cells.back().title, "m11");
  EXPECT_THAT(film.subtitle, HasSubstr("2 members, the first 12 of 58 cells; colour"));
  cells.resize(most_cells);
  EXPECT_THAT(film_of(cells, {}).subtitle, testing::Not(HasSubstr("cells")));
}

TEST(CloudFilm, ColoursMembersByTheOrderOfTheirStart) {
  auto const film = film_of({rotation("a", 3, 1)}, {});  // q = 1, −1/2, −1/2
  std::istringstream lines(film.data);
  std::vector<std::string> colours;
  std::string line, x, y, colour;
  for (std::getline(lines, line); colours.size() < 3 && lines >> x >> y >> colour;) colours.push_back(colour);
  EXPECT_EQ(colours[2], "0x440154") << "the lowest q, by the fourth digit: violet";
  EXPECT_NE(colours[0], colours[1]);
}

TEST(CloudFilm, ShowsThePlaneThatIsAskedFor) {
  auto const film = film_of({rotation("a", 8, 4)}, Plane{"phase", "q"});
  EXPECT_EQ(film.x, "phase");
  EXPECT_GT(film.x_range.high, 5);
  EXPECT_THAT(
      [] {
        film_of({rotation("a", 8, 4)}, Plane{"q", "phas"});
      },
      ThrowsMessage<InputError>(HasSubstr("no component 'phas'; did you mean 'phase'?")));
}

TEST(PlaneOfACloud, HasTwoComponentsOfStatesThatWereKept) {
  auto const with = std::vector{Orbits{}, rotation("a", 8, 4)}, without = std::vector{Orbits{}};
  EXPECT_NO_THROW(check_plane(with, {"q", "phase"}));
  EXPECT_THAT(
      [&] {
        check_plane(with, {"q", "q"});
      },
      ThrowsMessage<InputError>("a plane has two different components, not 'q' twice"));
  EXPECT_THAT(
      [&] {
        check_plane(with, {"q", "phas"});
      },
      ThrowsMessage<InputError>(HasSubstr("no component 'phas'; did you mean 'phase'?")));
  EXPECT_THAT(
      [&] {
        check_plane(without, {"foo", "bar"});
      },
      ThrowsMessage<InputError>(HasSubstr("no states to show in a plane: run the study with observe.states")));
}

TEST(CloudFilm, OfPointsThatCoincideStillHasAxes) {
  auto cell = rotation("a", 2, 2);
  std::fill(cell.states.begin(), cell.states.end(), 3.0);
  auto const film = film_of({cell}, {});
  EXPECT_LT(film.x_range.low, 3);
  EXPECT_GT(film.y_range.high, 3);
}

struct CloudFigure : testing::Test {
  fs::path folder =
      fs::path(testing::TempDir()) / "brouwer_clouds" / testing::UnitTest::GetInstance()->current_test_info()->name();
  void SetUp() override { fs::remove_all(folder); }
  void TearDown() override { fs::remove_all(folder); }
  std::string content(char const* name) const {
    std::ostringstream text;
    text << std::ifstream(folder / name, std::ios::binary).rdbuf();
    return text.str();
  }
};

bool have_gnuplot() { return std::system("gnuplot --version > /dev/null 2>&1") == 0; }

TEST_F(CloudFigure, IsAnAnimationAndAStill) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  auto const figures = draw_clouds({rotation("a", 16, 5), rotation("b", 16, 5)}, folder);
  EXPECT_EQ(figures.note, "");
  EXPECT_THAT(figures.files, ElementsAre(folder / "cloud.gif", folder / "cloud-still.svg"));
  EXPECT_THAT(content("cloud.gif"), testing::StartsWith("GIF89a"));
  EXPECT_THAT(content("cloud.gif"), HasSubstr("NETSCAPE2.0")) << "it is to run again and again";
  EXPECT_THAT(content("cloud-still.svg"), HasSubstr("t = 0.5"));
  for (auto const* name : {"cloud.gp", "cloud.dat", "cloud-still.gp"}) EXPECT_TRUE(fs::exists(folder / name)) << name;
}

TEST_F(CloudFigure, SaysHowManyAreOutOfSightAndHowManyEnded) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  auto cell = with_one_gone(rotation("a", 8, 2));
  cell.states[(4 * 3 + 2) * 3] = std::nan("");
  draw_clouds({cell}, folder);
  auto const still = content("cloud-still.svg");
  EXPECT_THAT(still, HasSubstr(">1 of 8 out of sight<"));
  EXPECT_THAT(still, HasSubstr(">1 of 8 out of sight, 1 of 8 ended<"));
}

TEST_F(CloudFigure, OfManyCellsIsDrawnAndTheNoteSaysOfWhich) {
  std::vector<Orbits> cells;
  for (int i = 0; i < 58; ++i) cells.push_back(rotation("m" + std::to_string(i), 2, 1));
  auto const figures = draw_clouds(cells, folder);
  EXPECT_THAT(figures.note, testing::StartsWith("cloud: the first 12 of 58 cells"));
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  EXPECT_EQ(figures.note, "cloud: the first 12 of 58 cells");
  for (auto const& file : figures.files) EXPECT_GT(fs::file_size(file), 1000u) << file;
  EXPECT_EQ(figures.files.size(), 2u);
}

TEST_F(CloudFigure, ThatGnuplotFailsOnLeavesNoFile) {
  if (!have_gnuplot()) GTEST_SKIP() << "there is no gnuplot";
  fs::create_directories(folder);
  Figures figures;
  std::string const begun = "set terminal svg\nset output 'x.svg'\nplot x\n";
  draw_script(folder, "x", "svg", begun + "nonsense\n", figures);
  EXPECT_THAT(figures.note, HasSubstr("gnuplot failed on x.gp"));
  draw_script(folder, "y", "svg", "set terminal svg\nset output 'y.svg'\n", figures);
  EXPECT_THAT(figures.note, HasSubstr("gnuplot failed on y.gp"));
  EXPECT_TRUE(figures.files.empty());
  for (auto const* name : {"x.svg", "y.svg"}) EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (auto const* name : {"x.gp", "y.gp"}) EXPECT_TRUE(fs::exists(folder / name)) << name;
  draw_script(folder, "x", "svg", begun, figures);
  EXPECT_EQ(figures.files.size(), 1u);
}

TEST_F(CloudFigure, TakesAnyNameAsWordsAndRunsNoneOfThem) {
  auto cells = std::vector{rotation("a", 4, 2), rotation("b", 4, 2)};
  for (auto& cell : cells) {
    cell.cell.method += "'; system('touch executed'); '`touch executed`\n}{@\"";
    cell.names[0] = "q'`touch executed`}}\n{";
  }
  auto const figures = draw_clouds(cells, folder);
  EXPECT_EQ(figures.note.empty(), have_gnuplot()) << figures.note;
  EXPECT_FALSE(fs::exists(folder / "executed"));
}

TEST_F(CloudFigure, OfNoStatesIsNone) {
  EXPECT_TRUE(draw_clouds({Orbits{}}, folder).files.empty());
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace
}  // namespace brouwer
