#include "ground/call_arguments.hpp"

#include "ground/record_text.hpp"

#include <algorithm>
#include <stdexcept>

namespace ground {

bool Arguments::has(std::string_view name) const
{
    return std::ranges::count(call_.arguments, name, &CallText::Argument::name) > 0;
}

double Arguments::take(std::string_view name, Dimension dimension, double least, double most,
                       std::optional<double> otherwise)
{
    for (auto a = call_.arguments.begin(); a != call_.arguments.end(); ++a) {
        if (a->name != name) continue;
        const double x = quantity(a->value, dimension);
        if (!(x >= least && x <= most))
            throw std::invalid_argument(call_.name + ": " + a->name + " " + a->value +
                                        " is out of range");
        call_.arguments.erase(a);
        return x;
    }
    if (!otherwise)
        throw std::invalid_argument(call_.name + ": missing " + std::string(name) +
                                    "; write it as in \"" + example_ + "\"");
    return *otherwise;
}

void Arguments::refuse_others() const
{
    if (call_.arguments.empty()) return;
    const std::string& name = call_.arguments.front().name;
    throw std::invalid_argument(call_.name + ": " +
                                (name.empty()
                                     ? in_quotes(call_.arguments.front().value) + " has no name"
                                     : in_quotes(name) + " is unknown or given twice") +
                                "; write it as in \"" + example_ + "\"");
}

} // namespace ground
