#include "uq/marginals/marginal_forms.hpp"

#include <type_traits>

namespace uq {
namespace {

template <class S> void add_forms(std::vector<MarginalForm>& all)
{
    for (const ShapeForm<S>& form : forms(static_cast<const S*>(nullptr))) {
        MarginalForm f{
            S::name, {}, [make = form.make](std::span<const double> values) -> Shape {
                return make(values.data());
            }};
        for (const ShapeParameter& p : form.parameters)
            if (!p.name.empty()) f.parameters.push_back(p);
        all.push_back(f);
    }
}

template <class... S>
std::vector<MarginalForm> all_forms(std::type_identity<std::variant<S...>>)
{
    std::vector<MarginalForm> all;
    (add_forms<S>(all), ...);
    return all;
}

} // namespace

const std::vector<MarginalForm>& marginal_forms()
{
    static const std::vector<MarginalForm> all = all_forms(std::type_identity<Shape>{});
    return all;
}

} // namespace uq
