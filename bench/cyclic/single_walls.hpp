#pragma once
/// Loops of single walls: blocks with closed forms, the speed of the drive, the cost of a
/// protocol.

#include "app/output/table/table.hpp"

namespace bench {

/// A block that slides and blocks that rock, beside their closed forms.
[[nodiscard]] app::Table block_loops();

/// Losses of a block that rocks with a free toe, for several contact points, modes and speeds.
[[nodiscard]] app::Table rocking_loops();

/// The same of a rigid block with other friction, points and amplitudes, beside a block that is
/// in balance at every moment, and with finite displacements.
[[nodiscard]] app::Table rocking_in_balance();

/// Energy of each cycle of the paper's wall at 0.50 MPa for several speeds of the drive.
[[nodiscard]] app::Table loops_over_speed();

/// Steps of a push of 30 mm and of cycles of 3, 6, 10, 15, 20 and 30 mm, under five stresses.
[[nodiscard]] app::Table protocol_cost();

} // namespace bench
