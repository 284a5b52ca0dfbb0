#pragma once
/// Asking a model for answers: what goes wrong with one sample stays with that sample.

#include "uq/reliability/black_box.hpp"

#include <cstddef>

namespace uq {

/// Parameters of one sample [as in Samples], in; its responses, out. May throw.
using RowFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>;

/// A model of `responses` columns that asks `f` sample by sample. A sample for which `f`
/// throws, or gives another number of values or one that is not finite, is a failed sample.
/// @throws std::invalid_argument if `f` is empty or `responses` < 1
[[nodiscard]] Model by_rows(RowFunction f, Eigen::Index responses);

/// The model asked for at most `size` samples at a time, in order.
/// @throws std::invalid_argument if `model` is empty or `size` < 1
[[nodiscard]] Model in_batches(Model model, Eigen::Index size);

/// Answers with at least `columns` columns, every row either finite or failed with a reason. If
/// the model throws, or answers in another shape, its samples are asked one by one: only those
/// that do so alone have failed. Other exceptions than std::exception pass.
/// @throws std::invalid_argument if `model` is empty or rows of `x` and `id` differ in number
[[nodiscard]] Responses evaluate(const Model& model, const Samples& samples,
                                 Eigen::Index columns = 1);

[[nodiscard]] std::size_t count_failed(const Responses& r);

} // namespace uq
