#include "dem/block/build_cost.hpp"

#include "dem/block/contact_count.hpp"
#include "dem/block/sparse_modes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace dem {

namespace {

// Fitted to walls of three courses with up to 40 points to a half unit and courses of up to 10
// m, AMD EPYC.
constexpr double kDenseRate = 1.5e9; // [operations/s]
constexpr double kDenseCopies = 4.7; // of the displacements of all nodes by those of the points
constexpr double kEigen = 25.0;      // operations / n^3 of a generalised eigenvalue problem
constexpr double kEntrySeconds = 6e-7; // for an entry of the factors of a sparse block
constexpr double kEntryBytes = 30.0, kDouble = 8.0;
constexpr double kFactorSeconds = 1.5e-7,
                 kFactorBytes = 20.0; // of a dense one, before its points are condensed

/// Size of a block that its cost depends on.
struct Size {
    double dofs = 0.0;         ///< of its zones
    double narrow = 0.0;       ///< of the shorter way through them
    double points = 0.0;       ///< of contact, on all faces
    double longest_face = 0.0; ///< [points]
    int modes = 0;
};

BuildCost cost_of(const Size& s)
{
    const bool dense = s.modes == 0 || s.points <= static_cast<double>(kManyPoints);
    if (dense) {
        const double columns = 2.0 * s.points;
        constexpr int kFields = 6; // modes that need no eigenvectors
        const bool eigenvectors = s.modes == 0 || s.modes > kFields;
        const double operations = 2.0 * s.dofs * columns * columns +
                                  (eigenvectors ? kEigen * columns * columns * columns : 0.0);
        const double entries = s.dofs * s.narrow;
        return {operations / kDenseRate + kFactorSeconds * entries,
                kDenseCopies * kDouble * s.dofs * columns + kFactorBytes * entries};
    }
    const double row = s.narrow + 4.0 * s.longest_face; // points of a face move one another
    return {kEntrySeconds * s.dofs * row, kEntryBytes * s.dofs * row};
}

} // namespace

BuildCost build_cost(const Layout& layout, const Discretisation& d)
{
    const std::size_t n = layout.blocks.size();
    std::vector<std::vector<double>> points(n);
    for (const Face& f : layout.faces)
        for (const int block : {f.a, f.b})
            if (block != kGround)
                points[static_cast<std::size_t>(block)].push_back(
                    static_cast<double>(contact_count(f, layout, d)));
    const double zone = layout.half_unit / ((d.contact_points - 1) * d.zones_per_interval);
    std::set<std::vector<double>> seen; // blocks that are alike are made once
    BuildCost all;
    for (std::size_t i = 0; i < n; ++i) {
        const Block& b = layout.blocks[i];
        const double width = b.x1 - b.x0, height = b.z1 - b.z0;
        const bool beam = static_cast<int>(i) == layout.beam;
        std::vector<double> key = points[i];
        for (const double x : {width * 1e6, height * 1e6, static_cast<double>(b.motion)})
            key.push_back(std::round(x));
        if (!seen.insert(key).second) continue;
        Size s;
        const double across = std::ceil(width / zone) + 1.0,
                     up = std::ceil(height / zone) + 1.0;
        s.dofs = 2.0 * across * up;
        s.narrow = 2.0 * std::min(across, up);
        for (const double p : points[i]) {
            s.points += p;
            s.longest_face = std::max(s.longest_face, p);
        }
        s.modes = beam ? d.beam_modes : d.block_modes;
        const BuildCost c = cost_of(s);
        all.seconds += c.seconds;
        if (c.bytes <= all.bytes) continue;
        all.bytes = c.bytes;
        all.beam = beam;
    }
    return all;
}

} // namespace dem
