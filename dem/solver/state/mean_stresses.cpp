#include "dem/solver/state/mean_stresses.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/state/recorder.hpp"

#include <algorithm>
#include <utility>

namespace dem {

template <class Real> void MeanStresses::add(const WallState<Real>& state, int lane, double way)
{
    if (now_.steps++ % kEvery != 0) return;
    now_.stress.resize(state.stress.size());
    now_.way += way;
    for (std::size_t i = 0; i < now_.stress.size(); ++i)
        now_.stress[i] += way * dem::lane(state.stress[i], lane);
}

void MeanStresses::end_interval()
{
    ended_.push_back(std::exchange(now_, {}));
    int steps = 0;
    std::size_t needed = 0;
    for (auto s = ended_.rbegin(); s != ended_.rend() && steps < Recorder::kSteps; ++s) {
        steps += s->steps;
        ++needed;
    }
    while (ended_.size() > needed) ended_.pop_front();
}

/// Contacts stand in the faces in the order of their numbers (take_snapshot.cpp).
void MeanStresses::give_to(Snapshot& snapshot, const Model& model, std::size_t intervals) const
{
    std::vector<double> sum;
    double way = 0.0;
    const auto last = static_cast<std::ptrdiff_t>(std::min(intervals, ended_.size()));
    for (auto s = ended_.end() - last; s != ended_.end(); ++s) {
        sum.resize(std::max(sum.size(), s->stress.size()));
        for (std::size_t i = 0; i < s->stress.size(); ++i) sum[i] += s->stress[i];
        way += s->way;
    }
    if (!(way > 0.0)) return;
    std::vector<std::size_t> next(snapshot.faces.size(), 0);
    std::size_t number = 0;
    for (const auto* contacts : {&model.dry, &model.tied, &model.cracks})
        for (const Contact& c : *contacts) {
            const auto face = static_cast<std::size_t>(c.face);
            ContactState& state = snapshot.faces[face].contacts[next[face]++];
            state.mean_sigma = sum[2 * number] / way;
            state.mean_tau = sum[2 * number + 1] / way;
            ++number;
        }
}

template void MeanStresses::add(const WallState<double>&, int, double);
template void MeanStresses::add(const WallState<Pack>&, int, double);

} // namespace dem
