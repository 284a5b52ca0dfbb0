#pragma once
/// Asking a model for answers: what goes wrong with one sample stays with that sample.

#include "uq/reliability/limit_state/black_box.hpp"

namespace uq {

/// Answers with at least `columns` columns, every row either finite or failed with a reason. If
/// the model throws, or answers in another shape, its samples are asked one by one: only those
/// that do so alone have failed. Other exceptions than std::exception pass.
/// @throws std::invalid_argument if `model` is empty or rows of `x` and `id` differ in number
[[nodiscard]] Responses evaluate(const BlackBox& model, const Samples& samples,
                                 Eigen::Index columns = 1);

} // namespace uq
