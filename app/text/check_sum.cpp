#include "app/text/check_sum.hpp"

#include <cstdint>
#include <sstream>

namespace app {

std::string check_sum(std::string_view content)
{
    std::uint64_t sum = 0xcbf29ce484222325U;
    for (const char c : content) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    std::ostringstream text;
    text << std::hex << sum;
    return text.str();
}

} // namespace app
