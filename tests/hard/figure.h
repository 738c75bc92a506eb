// tests/hard: a test's figure beside its bound, on the terminal and for the table in
// docs/numerics.md.
#pragma once

#include <cstddef>
#include <string_view>

namespace alhazen::hard {

// `count` rays in a run on every commit, many times as many in a long one.
std::size_t rays(std::size_t count);

// Prints "A1 double: relative error of t = 2.9 eps (bound 4)" and, where ALHAZEN_HARD_FIGURES names
// a file, appends it there as a line of JSON. Fails the test when the figure is above the bound or
// is NaN.
void figure(std::string_view id, std::string_view scalar, std::string_view what, double measured,
            double bound, std::string_view unit = "");

// The same where the scalar type cannot hold the bound: prints and keeps the figure, demands
// nothing. `why` says what the type lacks.
void figure_beyond(std::string_view id, std::string_view scalar, std::string_view what,
                   double measured, double bound, std::string_view unit, std::string_view why);

}  // namespace alhazen::hard
