#include "app/sampling/study_kernel.hpp"

#include "app/input/study/study.hpp"

namespace app {
namespace {

uq::Kernel by_group(uq::Group group, const Study& study)
{
    return {{uq::GroupCorrelation{group, study.uq.group_correlation}}};
}

void check_lengths(const Study& study)
{
    const FieldKernel k = study.uq.kernel;
    const bool by_distance = k == FieldKernel::exponential || k == FieldKernel::matern ||
                             k == FieldKernel::squared_exponential ||
                             k == FieldKernel::exponential_l1;
    const std::size_t n = study.uq.correlation_length.size();
    const std::size_t most = k == FieldKernel::exponential_l1 ? 2 : 1;
    if (by_distance && n == 0)
        throw error_at(study.source, "uq.correlation_length",
                       "missing; write e.g. \"correlation_length = 0.30 m\" under [uq]");
    if (by_distance && n > most)
        throw error_at(study.source, "uq.correlation_length",
                       "has " + std::to_string(n) + " values; this kernel takes " +
                           (most == 1 ? "one" : "one, or two: along x and z"));
    if (!by_distance && n > 0)
        throw error_at(study.source, "uq.correlation_length",
                       "has no meaning for a kernel by group; write uq.group_correlation");
}

} // namespace

uq::Kernel kernel_of(const Study& study)
{
    check_lengths(study);
    const std::vector<double>& l = study.uq.correlation_length;
    switch (study.uq.kernel) {
    case FieldKernel::exponential:
        return {{uq::Exponential{l.front()}}};
    case FieldKernel::squared_exponential:
        return {{uq::SquaredExponential{l.front()}}};
    case FieldKernel::exponential_l1:
        return {{uq::ExponentialL1{l.front(), l.back()}}};
    case FieldKernel::matern:
        return {{uq::Matern{study.uq.matern_nu, l.front()}}};
    case FieldKernel::same_course:
        return by_group(uq::Group::course, study);
    case FieldKernel::same_unit:
        return by_group(uq::Group::unit, study);
    case FieldKernel::all:
        break;
    }
    return by_group(uq::Group::all, study);
}

} // namespace app
