#pragma once

namespace brouwer {

/// The exact flow of a system, where there is one: ExactFlow<System>::type is made from a system and a start and gives
/// the state at any time. Specialised beside the flow (rigid_body_flow.hpp).
template <class System>
struct ExactFlow;

template <class System>
concept HasExactFlow = requires {
  typename ExactFlow<System>::type;
};

}  // namespace brouwer
