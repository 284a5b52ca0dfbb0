#include "bench/uq/uq_fields.hpp"

#include <openturns/OT.hxx>
#include <openturns/TBBImplementation.hxx>

namespace bench {

OtherTimes other_times(int repeats)
{
    OT::TBBImplementation::Disable();
    OT::Sample vertices(kFieldColumns * kFieldRows, 2);
    for (int k = 0; k < kFieldRows; ++k)
        for (int i = 0; i < kFieldColumns; ++i) {
            const auto site = static_cast<OT::UnsignedInteger>(k * kFieldColumns + i);
            vertices(site, 0) = i * kFieldDx;
            vertices(site, 1) = k * kFieldDz;
        }
    const OT::Mesh mesh(vertices);
    const OT::ExponentialModel model(OT::Point(2, kFieldLength), OT::Point(1, 1.0));
    OtherTimes t;
    t.name = "OpenTURNS " + OT::PlatformInfo::GetVersion();
    OT::CovarianceMatrix c;
    t.matrix = cpu_ms(repeats, [&] { c = model.discretize(mesh); });
    t.correlation.resize(vertices.getSize(), vertices.getSize());
    for (OT::UnsignedInteger j = 0; j < vertices.getSize(); ++j)
        for (OT::UnsignedInteger i = 0; i < vertices.getSize(); ++i)
            t.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = c(i, j);
    t.cholesky = cpu_ms(repeats, [&] {
        OT::CovarianceMatrix fresh(c); // keeps its factor once computed
        fresh.computeCholesky();
    });
    t.build_and_one = cpu_ms(
        repeats, [&] { static_cast<void>(OT::GaussianProcess(model, mesh).getRealization()); });
    t.coordinates = cpu_ms(
        repeats, [&] { static_cast<void>(OT::DistFunc::rNormal(1000 * vertices.getSize())); });
    t.thousand = cpu_ms(
        repeats, [&] { static_cast<void>(OT::GaussianProcess(model, mesh).getSample(1000)); });
    return t;
}

} // namespace bench
