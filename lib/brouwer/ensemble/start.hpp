#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <brouwer/ensemble/catalogue.hpp>
#include <brouwer/ensemble/study.hpp>
#include <brouwer/store/record.hpp>

namespace brouwer {

/// The study's values as they stand, without perturbation.
Start nominal_start(Study const& study, SystemDescription const& system);

/// Member `member`'s start: the nominal one, perturbed with random numbers that depend on (seed, member)
/// alone (Philox 4×64, Random123). A draw that the system refuses (an impossible inertia) is drawn again
/// from the same stream; InputError after 1000 refusals.
Start member_start(Study const& study, SystemDescription const& system, std::int64_t member);

/// What `arithmetic` makes of doubles: they are rounded where it is narrower (float), and the same elsewhere. A member
/// and its reference start from these, so that their difference is round-off of the steps alone.
double rounded_to(std::string const& arithmetic, double value);
Start rounded_to(std::string const& arithmetic, Start start);

/// The starts of `count` members from `first`, as `arithmetic` holds them.
std::vector<Start> member_starts(Study const& study, SystemDescription const& system, std::string const& arithmetic,
                                 std::int64_t first, std::int64_t count);

/// Which random numbers stochastic rounding takes: those of a study's members from `first_member` on.
struct RandomStreams {
  std::uint64_t seed = 0;
  std::int64_t first_member = 0;
};

/// Trajectories of a cell's method and arithmetic from `starts`: in the widest packs up to `widest` that the method has
/// in this arithmetic, one by one where there are none or there is one member. The bits do not depend on it.
/// @param whole_state  false: nothing observed needs all of it; parts may stay at their start
std::unique_ptr<Trajectories> begin_trajectories(Catalogue const& catalogue, CellLabels const& cell,
                                                 std::vector<Start> const& starts, bool whole_state,
                                                 InstructionSet widest, RandomStreams const& streams = {});

/// The same for one member.
std::unique_ptr<Trajectories> begin_trajectory(Catalogue const& catalogue, CellLabels const& cell, Start const& start,
                                               bool whole_state, RandomStreams const& streams = {});

}  // namespace brouwer
