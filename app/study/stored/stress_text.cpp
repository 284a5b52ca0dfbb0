#include "app/study/stored/stress_text.hpp"

#include "app/text/number_text.hpp"

namespace app {

std::string stress_text(double stress)
{
    const std::string all = number(stress / 1e6, 12), two = fixed(stress / 1e6, 2);
    return (number(std::stod(two), 12) == all ? two : all) + " MPa";
}

} // namespace app
