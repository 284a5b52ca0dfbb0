#include "bench/uq/uq_sampling.hpp"

#include "uq/designs/design_criteria.hpp"

#include <openturns/OT.hxx>
#include <openturns/TBBImplementation.hxx>

namespace bench {
namespace {

OT::ComposedDistribution distribution(int d)
{
    OT::ComposedDistribution::DistributionCollection marginals;
    for (int j = 0; j < d; ++j) {
        if (j % 2 == 0)
            marginals.add(OT::Normal(kNormalMean, kNormalMean * kNormalCov));
        else
            marginals.add(OT::LogNormal(
                OT::LogNormalMuSigma(kLognormalMean, kLognormalMean * kLognormalCov)
                    .evaluate()[0],
                OT::LogNormalMuSigma(kLognormalMean, kLognormalMean * kLognormalCov)
                    .evaluate()[1]));
    }
    return OT::ComposedDistribution(marginals);
}

Eigen::MatrixXd matrix(const OT::Sample& s)
{
    Eigen::MatrixXd m(s.getSize(), s.getDimension());
    for (OT::UnsignedInteger i = 0; i < s.getSize(); ++i)
        for (OT::UnsignedInteger j = 0; j < s.getDimension(); ++j)
            m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = s(i, j);
    return m;
}

/// phi_50, its schedule with 20000 exchanges.
void optimised(SamplingTimes& t, int repeats)
{
    const OT::ComposedDistribution cube(
        OT::ComposedDistribution::DistributionCollection(kFewVariables, OT::Uniform(0.0, 1.0)));
    const OT::LHSExperiment latin(cube, kFewSamples, true);
    t.distance.resize(repeats);
    t.spread = median_cpu_ms(repeats, [&](int i) {
        OT::SimulatedAnnealingLHS annealing(latin, OT::SpaceFillingPhiP(50),
                                            OT::GeometricProfile(10.0, 0.95, 20000));
        t.distance[i] = uq::minimum_distance(matrix(annealing.generate()));
    });
}

} // namespace

SamplingTimes openturns_times(int repeats)
{
    OT::TBBImplementation::Disable();
    SamplingTimes t;
    t.name = "OpenTURNS " + OT::PlatformInfo::GetVersion();
    const OT::ComposedDistribution few = distribution(kFewVariables),
                                   many = distribution(kManyVariables);
    OT::LHSExperiment few_latin(few, kFewSamples, true), many_latin(many, kManySamples, true);
    t.few_latin = median_cpu_ms(101,
                                [&](int) {
                                    for (int k = 0; k < 20; ++k)
                                        static_cast<void>(few_latin.generate());
                                }) /
                  20.0;
    t.many_latin =
        median_cpu_ms(repeats, [&](int) { static_cast<void>(many_latin.generate()); });
    t.many_independent =
        median_cpu_ms(repeats, [&](int) { static_cast<void>(many.getSample(kManySamples)); });
    t.many_sobol = median_cpu_ms(repeats, [&](int) {
        static_cast<void>(
            OT::LowDiscrepancyExperiment(OT::SobolSequence(), many, kManySamples).generate());
    });
    optimised(t, repeats);
    return t;
}

} // namespace bench
