#pragma once
#include <memory>

namespace brouwer {

/// The exact flow of a system, where there is one: ExactFlow<System>::type is made from a system and a start and gives
/// the state at any time. Specialised beside the flow (rigid_body_flow.hpp).
template <class System>
struct ExactFlow;

template <class System>
concept HasExactFlow = requires {
  typename ExactFlow<System>::type;
};

/// Holds a system's exact flow once it is asked for; nothing where there is none.
template <class System>
struct FlowHolder {};

template <HasExactFlow System>
struct FlowHolder<System> {
  std::shared_ptr<typename ExactFlow<System>::type> flow;
};

}  // namespace brouwer
