#include "uq/reliability/noted_model.hpp"

#include "uq/reliability/limit_state/evaluate.hpp"

#include <algorithm>
#include <span>

namespace uq {

BlackBox noted_model(const LimitState& event, std::vector<Evaluated>& seen,
                     const OnBatch& on_batch)
{
    return [model = event.model, response = event.response, &seen,
            on_batch](const Samples& samples) {
        const Eigen::Index n = samples.x.rows();
        Responses all{Eigen::MatrixXd(n, response + 1), {}};
        for (Eigen::Index first = 0, rows = 0; first < n; first += rows) {
            const bool any =
                std::ranges::any_of(seen, [](const Evaluated& e) { return e.failure.empty(); });
            rows = any ? n - first : std::min<Eigen::Index>(kUntilSound, n - first);
            const Responses r =
                evaluate(model,
                         {samples.x.middleRows(first, rows),
                          {samples.id.begin() + first, samples.id.begin() + first + rows}},
                         response + 1);
            const std::size_t before = seen.size();
            for (Eigen::Index i = 0; i < rows; ++i)
                seen.push_back(
                    {samples.x.row(first + i).transpose(), r.y(i, response), r.failure[i]});
            all.y.middleRows(first, rows) = r.y.leftCols(response + 1);
            all.failure.insert(all.failure.end(), r.failure.begin(), r.failure.end());
            if (on_batch) on_batch(std::span(seen).subspan(before));
        }
        return all;
    };
}

} // namespace uq
