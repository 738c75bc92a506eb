// app/page: bytes as text, for pictures that stand in the page itself.
#pragma once

#include <string>
#include <string_view>

namespace alhazen {

// RFC 4648 section 4: the alphabet with + and /, padded with =, no line breaks.
std::string base64(std::string_view bytes);

}  // namespace alhazen
