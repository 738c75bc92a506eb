// app/cli: quantities as people read them: three digits are what an eye takes in.
#pragma once

#include <cstdint>
#include <string>

namespace alhazen {

std::string count_text(double count);  // 1234567: "1.23 M"
std::string bytes_text(std::uint64_t bytes);
std::string seconds_text(double seconds);

}  // namespace alhazen
