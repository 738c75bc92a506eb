// core/base: one lambda per alternative for std::visit.
#pragma once

namespace alhazen {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace alhazen
