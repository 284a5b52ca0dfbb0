#pragma once
/// Tables with what a step needs to know about the model. They are made once and shared by all
/// walls.

#include "dem/contact/contact_operator.hpp"
#include "dem/solver/state/finite_tables.hpp"

#include <array>
#include <vector>

namespace dem {

struct Model; // dem/block/model.hpp

/// The contacts of one face: they share a law and are neighbours in the arrays.
struct ContactRun {
    int first = 0, count = 0;
    int law = 0; ///< index in the arrays of laws
};

/// The share of a row of the contacts in a horizontal motion, and in the force that belongs to
/// it.
struct HorizontalShare {
    int row = 0;         ///< 2 contact + (0 normal, 1 tangential)
    double factor = 0.0; ///< of the horizontal displacement that is relative displacement [-]
    double area = 0.0;   ///< [m2]
};

/// Contacts are numbered: first the dry ones, then the tied ones, then the cracks, each in the
/// order of the model.
struct StepTables {
    struct BlockRow {
        int element, first_port, first_mode, modes;
    };
    std::vector<BlockRow> blocks;
    std::vector<ContactOperator> matrices; ///< by element
    std::vector<int> port_contact;         ///< by port: contact
    std::vector<double> lambda;            ///< by mode
    std::vector<double> area;              ///< by contact [m2]
    std::vector<ContactRun> dry, tied, cracks;
    std::vector<std::array<int, 2>> dry_blocks; ///< by run of dry contacts: blocks, or kGround
    int first_tied = 0, first_crack = 0, n_contacts = 0;
    bool body_forces = false;            ///< push the wall, in place of a drive of the beam
    std::vector<HorizontalShare> beam;   ///< what moves with the drive
    std::vector<HorizontalShare> ground; ///< what hands horizontal force to the ground
    FiniteTables finite;
};

[[nodiscard]] StepTables step_tables(const Model& model);

} // namespace dem
