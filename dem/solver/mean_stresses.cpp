#include "dem/solver/mean_stresses.hpp"

#include "dem/block/model.hpp"

#include <cstddef>

namespace dem {

template <class Real> void MeanStresses::add(const WallState<Real>& state, int lane, double way)
{
    if (steps_++ % kEvery != 0) return;
    sums_.resize(state.stress.size());
    way_ += way;
    for (std::size_t i = 0; i < sums_.size(); ++i)
        sums_[i] += way * dem::lane(state.stress[i], lane);
}

/// Contacts stand in the faces in the order of their numbers (take_snapshot.cpp).
void MeanStresses::give_to(Snapshot& snapshot, const Model& model)
{
    if (way_ > 0.0) {
        std::vector<std::size_t> next(snapshot.faces.size(), 0);
        std::size_t number = 0;
        for (const auto* contacts : {&model.dry, &model.tied, &model.cracks})
            for (const Contact& c : *contacts) {
                const auto face = static_cast<std::size_t>(c.face);
                ContactState& state = snapshot.faces[face].contacts[next[face]++];
                state.mean_sigma = sums_[2 * number] / way_;
                state.mean_tau = sums_[2 * number + 1] / way_;
                ++number;
            }
    }
    start_again();
}

void MeanStresses::start_again()
{
    sums_.assign(sums_.size(), 0.0);
    way_ = 0.0;
    steps_ = 0;
}

template void MeanStresses::add(const WallState<double>&, int, double);
template void MeanStresses::add(const WallState<Pack>&, int, double);

} // namespace dem
