#include "app/sampling/study_kernel.hpp"

#include "app/input/study/study.hpp"

namespace app {
namespace {

uq::Kernel by_group(uq::Group group, const UqInput& uq)
{
    return {{uq::GroupCorrelation{group, uq.group_correlation}}};
}

void check_lengths(const UqInput& uq, const StudyFile& source)
{
    const FieldKernel k = uq.kernel;
    const bool by_distance = k == FieldKernel::exponential || k == FieldKernel::matern ||
                             k == FieldKernel::squared_exponential ||
                             k == FieldKernel::exponential_l1;
    const std::size_t n = uq.correlation_length.size();
    const std::size_t most = k == FieldKernel::exponential_l1 ? 2 : 1;
    if (by_distance && n == 0)
        throw error_at(source, "uq.correlation_length",
                       "missing; write e.g. \"correlation_length = 0.30 m\" under [uq]");
    if (by_distance && n > most)
        throw error_at(source, "uq.correlation_length",
                       "has " + std::to_string(n) + " values; this kernel takes " +
                           (most == 1 ? "one" : "one, or two: along x and z"));
    if (!by_distance && n > 0)
        throw error_at(source, "uq.correlation_length",
                       "has no meaning for a kernel by group; write uq.group_correlation");
}

} // namespace

uq::Kernel kernel_of(const UqInput& uq, const StudyFile& source)
{
    check_lengths(uq, source);
    const std::vector<double>& l = uq.correlation_length;
    switch (uq.kernel) {
    case FieldKernel::exponential:
        return {{uq::Exponential{l.front()}}};
    case FieldKernel::squared_exponential:
        return {{uq::SquaredExponential{l.front()}}};
    case FieldKernel::exponential_l1:
        return {{uq::ExponentialL1{l.front(), l.back()}}};
    case FieldKernel::matern:
        return {{uq::Matern{uq.matern_nu, l.front()}}};
    case FieldKernel::same_course:
        return by_group(uq::Group::course, uq);
    case FieldKernel::same_unit:
        return by_group(uq::Group::unit, uq);
    case FieldKernel::all:
        break;
    }
    return by_group(uq::Group::all, uq);
}

} // namespace app
