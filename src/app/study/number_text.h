// app/study: numbers as people read them.
#pragma once

#include <string>

namespace alhazen {

// Three digits: "0.0123", "4.56", "789", "1230", and from 10^5 on and below 10^-3 as "1.2e-05"
// with two. Zero is "0".
std::string number_text(double value);

// The same with a raised exponent, for pages: "1.2 x 10^-5" with the signs of print.
std::string print_number(double value);

// "12 ms", "1.23 s", "2 min 05 s".
std::string duration_text(double seconds);

// "12.3 %", "0.04 %".
std::string percent_text(double share);

// How many times: "3.2", "14", "0.41".
std::string ratio_text(double ratio);

}  // namespace alhazen
