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
       R"(Runs a few members for a moment to measure the speed and the diffusion. The smallest visible drift is the one
that the whole ensemble would see at the level of the test with a chance of 90 %; it falls as 1/√(members × steps).

Example:
  brouwer plan studies/elliptic-drift.toml --members 100000)"},
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
  brouwer check results/elliptic-drift)"},
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
       R"(Long form: columns time, member, error (one more, quantity, where there are several). Wide form: time first,
then one column a member. Times are > 0 and increasing; the error at time 0 is 0 by definition and left out.

Example:
  brouwer fit errors.csv --format json --plot figures)"},
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
