#include "dem/contact/contact_operator.hpp"

namespace dem {

ContactOperator with_own_matrix(const ContactOperator& a)
{
    ContactOperator once;
    once.ports = a.ports;
    once.modes = a.modes;
    const int rows = 2 * a.ports;
    for (int first = 0; first < rows; first += detail::kTileRows)
        for (int i = 0; i < a.modes; ++i)
            for (int row = first; row < first + detail::kTileRows; ++row)
                once.own.push_back(
                    row < rows ? a.to_contacts[static_cast<std::size_t>(i) * rows + row] : 0.0);
    return once;
}

} // namespace dem
