#pragma once
#include <vector>

#include <brouwer/ensemble/trajectories.hpp>
#include <brouwer/scalar/modelled.hpp>

namespace brouwer {

/// How the members of a request compute, in the scalar T: as the processor does.
template <class T>
class MemberOperations {
 public:
  static constexpr bool chosen = false;
  /// For the time of a scope.
  struct Scope {
    ~Scope() {}  // NOLINT: it is a scope also where it does nothing
  };

  explicit MemberOperations(TrajectoryRequest const&) {}
  Scope forming_constants() const { return {}; }
  Scope steps(std::size_t) { return {}; }
  Scope steps_again(std::size_t) const { return {}; }
  void remember() {}
};

/// As the request's rule says; with stochastic rounding each member has its own random numbers, which depend on the seed
/// and its number in the study alone.
template <class T>
class MemberOperations<Modelled<T>> {
 public:
  static constexpr bool chosen = true;

  /// Steps of one member: what it leaves of its random numbers is kept for the next.
  class Scope {
   public:
    Scope(OperationContext const& context, MemberRandom* kept) : scope_(context), kept_(kept) {}
    ~Scope() {
      if (kept_) *kept_ = operation_context.random;
    }
    Scope(Scope const&) = delete;
    Scope& operator=(Scope const&) = delete;

   private:
    ContextScope scope_;
    MemberRandom* kept_;
  };

  explicit MemberOperations(TrajectoryRequest const& request) : rule_(request.rule) {
    for (std::size_t i = 0; i < request.starts.size(); ++i)
      random_.emplace_back(request.seed, static_cast<std::uint64_t>(request.first_member) + i);
    before_ = random_;
  }

  Scope forming_constants() const { return {{rule_, true, {}}, nullptr}; }
  Scope steps(std::size_t member) { return {{rule_, false, random_[member]}, &random_[member]}; }
  /// The same steps as since remember().
  Scope steps_again(std::size_t member) const { return {{rule_, false, before_[member]}, nullptr}; }
  void remember() { before_ = random_; }

 private:
  OperationRule rule_;
  std::vector<MemberRandom> random_, before_;
};

}  // namespace brouwer
