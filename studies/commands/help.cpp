#include "studies/commands/help.hpp"

#include <map>

namespace brouwer {

std::string help_introduction() {
  return "brouwer: how does round-off error grow in this integrator (as a random walk, as persistent slopes, as a\n"
         "drift), and what causes it? It runs an ensemble of perturbed starts, compares it with a wider arithmetic,\n"
         "fits the law of growth with intervals, and says a verdict that can serve as a regression test.";
}

std::string help_footer(std::string const& subcommand) {
  static std::map<std::string, std::string> const footers = {
      {"",
       R"(Examples:
  brouwer run studies/elliptic-drift.toml           a study, from its file to the verdicts
  brouwer run STUDY --members 8 --steps 1000        the same at toy size, in a folder of its own
  brouwer plan STUDY                                how long it would take and what it could see
  brouwer probe STUDY                               errors of single steps: the cause, and the long run predicted
  brouwer explain STUDY                             what makes a drift: constants, rounding, sums, the method
  brouwer check STUDY --junit outcome.xml           a drift-slope regression test for CI
  brouwer fit errors.csv                            the inference on an ensemble of another program
  brouwer integrate STUDY --steps 10 --hex          one trajectory, bit for bit

Files: a study is a TOML file with one question; its results are a folder (study.toml, provenance, and one HDF5
file a work unit). Running again computes only what is missing.

Exit status: 0 done, or every expectation holds; 1 an expectation failed; 2 wrong usage or input, nothing was
written; 3 something failed at run time; 75 interrupted, the same command resumes.)"},
      {"run",
       R"(Runs what is missing, prints the growth table, a sentence a verdict and the expectations. Ctrl-C keeps every
finished unit; the same command resumes. Where --members, --steps or --set change the study, its results go to a
folder of their own (results/NAME-xxxxxxxx).

Examples:
  brouwer run studies/elliptic-drift.toml
  brouwer run studies/elliptic-drift.toml --members 16 --set integrate.arithmetic=float -o /var/tmp/try)"},
      {"plan",
       R"(Measures the speed, and the diffusion by a probe of single steps. The smallest visible drift is the one that the
whole ensemble would see at the level of the test with a chance of 90 %; the smallest excluded one is the bound that the
interval of β would keep with that chance if there is no drift. Both fall as 1/√(members × steps) while members walk; where
they keep slopes of their own, more steps do not help, more members do.

Examples:
  brouwer plan studies/elliptic-drift.toml --members 100000
  brouwer plan studies/elliptic-drift.toml --drift 1e-19)"},
      {"probe",
       R"(Compares single steps along trajectories with steps of the same method in higher precision from the same state: the
error of rounding and the error of the method, their bias, size and correlation, and the drift β, the diffusion σ and the
slopes τ that a long run would have of them. Where there are results, or with --run, observation stands beside prediction.

Examples:
  brouwer probe studies/elliptic-drift.toml
  brouwer probe studies/gauss-kepler.toml --members 256 --windows 16 --format json)"},
      {"explain",
       R"(The nominal cell of each method and step has the first level that the study has of every other factor. It is run again
with the same starts in a factorial over exact constants, stochastic rounding and compensated sums, and with one other level
each of rounding, contraction, coefficients, special functions and precision, as far as they exist. Members are compared in
pairs; a cause is named where more than half of the drift is proven to stay, or to go, in the cells that tell it from others.
Other rules of rounding cost 20 to 60 times a number's own operations; --plan says how long it takes.

The design's results are kept in results/NAME-explain, or results/NAME-xxxxxxxx-explain where options have changed it. Ctrl-C
keeps every finished unit; the same command resumes.

Examples:
  brouwer explain studies/elliptic-drift.toml --set integrate.methods=elliptic-naive
  brouwer explain studies/gauss-henon-heiles.toml --members 64 --factors constants,coefficients,precision
  brouwer explain STUDY --plan)"},
      {"check",
       R"(A study file is run first, as far as it is not yet run. A folder is judged as it is.

What an [[expect]] may ask for, of a quantity or component, in the cells that `where` selects:
  drift = "none"                         none is seen at the level
  drift = { per_step = [low, high] }     the estimate lies inside, and is seen unless 0 does, too
  drift = { smaller_than = 1e-19 }       |drift| < 1e-19 per step is proven at the level (two one-sided t tests): what a
                                         regression test needs, because an ensemble too small to see a drift cannot
  growth = { exponent = 0.5, within = 0.05 }             RMS grows as t^exponent
  step_exponent = { exponent = 0.5, within = 0.1 }       … and as h^exponent, over three steps h or more
  persistence = "none"                   or "present": slopes that members keep
  verdict = ["random walk", "bounded"]   one of these
  mean = [low, high], rms = [low, high]  at the last sample
  failed = 0                             at most so many members have failed
  level = 0.01                           of its tests

[tests] level = 0.001 is that of all expectations that have none of their own. [tests] correction = "holm" keeps the
chance of any false alarm among all tests of the study below the level, "fdr" the share of false ones among the alarms
(for tests that are independent or depend positively); --correction takes its place.

Examples:
  brouwer check studies/elliptic-drift.toml --junit outcome.xml
  brouwer check results/elliptic-drift
  brouwer check studies/elliptic-drift.toml --baseline data/baselines/elliptic-drift.json

Guards are checked beside the expectations: that the state has moved, the frame rests, the members differ, t and F are
finite, most members came through. With --baseline, a row fails where its drift, diffusion or spread of slopes has grown
significantly, or where it is gone; all questions together are asked at --level.)"},
      {"baseline",
       R"(Records of each quantity of each cell the estimates with their intervals, and what it takes to compare another
ensemble with them; `check --baseline` does. Recording again adds an entry: one file holds a study's history. Nothing in it
depends on the day or on the number of threads; what compiled it, and for which processor, is kept.

Examples:
  brouwer baseline studies/elliptic-drift.toml -o data/baselines/elliptic-drift.json
  brouwer baseline results/elliptic-drift -o data/baselines/elliptic-drift.json --label "before the new series"
  brouwer baseline --list data/baselines/elliptic-drift.json)"},
      {"table",
       R"(Example:
  brouwer table results/elliptic-drift --format latex > growth.tex)"},
      {"plot",
       R"(Log-log growth with the fitted laws and Brouwer's line, histograms of the final errors, means with their
intervals. The gnuplot scripts and their data are kept beside the figures.

Example:
  brouwer plot results/elliptic-drift --format pdf -o figures)"},
      {"report",
       R"(HTML is one self-contained page of one result. Markdown (FILE.md) takes several: a table of all questions and how
many expectations hold, then a section each; its figures are put into the folder FILE-figures beside it.

Examples:
  brouwer report results/elliptic-drift -o elliptic-drift.html
  brouwer report results/* -o findings.md)"},
      {"fit",
       R"(Text: columns time, member, error (one more, quantity, where there are several), or time first, then one column a
member. HDF5, netCDF-4: a matrix members × times or times × members beside a vector `time`, `t` or `steps`, or with it as
dimension scale; several matrices are several ensembles. Times are > 0 and increasing; the error at time 0 is 0 by
definition and left out. Files of energies: --relative-to-start.

Examples:
  brouwer fit errors.csv --format json --plot figures
  brouwer fit run.h5 --dataset leapfrog/energy --relative-to-start)"},
      {"integrate",
       R"(Columns: t, the components of the state, then the first integrals. Decimal numbers have as many digits as the
arithmetic needs to be read back without loss.

Examples:
  brouwer integrate STUDY --method elliptic-naive --steps 100 --every 10
  brouwer integrate STUDY --member 3 --arithmetic float128 --hex | head)"},
      {"list",
       R"(Examples:
  brouwer list methods
  brouwer list studies)"},
      {"completion",
       R"(Examples:
  source <(brouwer completion bash)
  brouwer completion zsh > ~/.zfunc/_brouwer)"},
  };
  auto const found = footers.find(subcommand);
  return found == footers.end() ? "" : "\n" + found->second;
}

}  // namespace brouwer
