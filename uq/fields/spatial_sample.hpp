#pragma once
/// Samples of inputs that have one value each, or one value at each of many sites.
///
/// An input has coordinates on the standard normal axis: one for a single value, one for each
/// site if the sites are independent, as many as its random field needs, or none if it is
/// stratified inside the sample. A design has one column for each coordinate: first the first
/// coordinates of all inputs, then their second ones, and so on. Inputs of one value each
/// therefore have the first columns of the same inputs over sites.

#include "uq/designs/normal_copula.hpp"
#include "uq/designs/stream.hpp"
#include "uq/fields/field_basis.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace uq {

enum class OverSites {
    independent, ///< one coordinate of the design for each site
    stratified,  ///< a Latin hypercube over the sites of one sample, drawn anew for each sample
    field        ///< a random field
};

struct SpatialInput {
    Marginal marginal;
    int sites = 1;                           ///< values in a sample, >= 1
    OverSites over = OverSites::independent; ///< not used for one value
    std::size_t field = 0; ///< which of SpatialPlan::fields, for OverSites::field
};

/// Inputs of one value each whose values belong together, as draws of a posterior do. A sample
/// takes one row.
struct JointRows {
    std::vector<std::size_t> inputs; ///< empty: there are none
    /// Ascending in the first input, whose coordinate chooses the row.
    std::vector<std::vector<double>> rows;
};

struct SpatialPlan {
    std::vector<SpatialInput> inputs;
    std::vector<FieldBasis> fields;
    std::optional<NormalCopula>
        dependence;         ///< of the inputs' coordinates; nothing: independent
    bool reordered = false; ///< dependence comes from the order of the rows of the design
    std::vector<std::vector<int>> columns; ///< of the design, of each input
    int n_columns = 0;
    JointRows together{};
};

/// @param latin whether the design is a Latin hypercube. If it is and every input has one
/// value,
/// its rows are reordered to the dependence, so that it stays Latin; else coordinates are
/// mixed.
[[nodiscard]] SpatialPlan spatial_plan(std::vector<SpatialInput> inputs,
                                       std::vector<FieldBasis> fields,
                                       std::optional<NormalCopula> dependence, bool latin);

/// Reorders a Latin hypercube to the correlation of its normal scores (Iman and Conover 1982).
/// Rows of each size are reordered among themselves, so that rows of smaller sizes stay.
/// @param u rows of the last size x variables, in (0, 1)  @param sizes ascending
/// @throws std::invalid_argument if a size adds no more rows than there are variables
void reorder(Eigen::MatrixXd& u, const Eigen::MatrixXd& rho_z,
             std::span<const std::uint32_t> sizes);

/// One sample: the values of each input.
/// @param normal n_columns standard normal values: a row of the design
/// @param random read by OverSites::stratified only
[[nodiscard]] std::vector<std::vector<double>>
draw(const SpatialPlan& plan, const Eigen::VectorXd& normal, Stream& random);

} // namespace uq
